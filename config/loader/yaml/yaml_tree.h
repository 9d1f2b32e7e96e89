#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A node of a parsed YAML file. Lines and columns count from 1, columns in characters.
/// What an alias names is shared, so a node may hang in several places; there are no cycles.
struct YamlNode {
    enum class Kind { null, scalar, sequence, map };
    struct Entry;

    Kind kind = Kind::null;
    int line = 0;
    int column = 0;
    std::string text;     ///< scalar: without quotes
    bool quoted = false;  ///< scalar: in quotes or a block, so never a number or a truth value
    std::vector<std::shared_ptr<const YamlNode>> items;  ///< sequence
    std::vector<Entry> entries;                          ///< map, in the file's order, keys distinct
    std::size_t size = 1;                                ///< nodes below and this one, aliases spelled out
};

struct YamlNode::Entry {
    std::string key;
    int line = 0;
    int column = 0;
    std::shared_ptr<const YamlNode> value;
};

/// Parses a text that read_source accepted. Complains (null when nothing can be made of it):
///   yaml-syntax    what the parser says; a second document; an alias inside what it names
///   duplicate-key  at the second of the two; the first is kept
///   wrong-type     a key that is no plain word, a tag such as `!!float`
///   too-large      nested more than 64 deep, more than a million nodes with aliases spelled
///                  out, or more than ten thousand anchors
///   empty-file     nothing but comments
std::shared_ptr<const YamlNode> parse_yaml(const std::string& text, const std::string& file,
                                           scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
