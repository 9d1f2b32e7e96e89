#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A node of a parsed YAML file. Lines and columns count from 1, columns in characters.
/// Aliases share their node, so a node may have several parents; there are no cycles.
struct YamlNode {
    enum class Kind { null, scalar, sequence, map };
    struct Entry;

    Kind kind = Kind::null;
    int line = 0;
    int column = 0;
    std::string text;     ///< scalar: without quotes
    bool quoted = false;  ///< scalar: in quotes or a block, so never a number or a boolean
    std::vector<std::shared_ptr<const YamlNode>> items;  ///< sequence
    std::vector<Entry> entries;                          ///< map, in the file's order, keys distinct
    std::size_t size = 1;  ///< nodes below and this one, aliases expanded; of long texts more
};

struct YamlNode::Entry {
    std::string key;
    int line = 0;
    int column = 0;
    std::shared_ptr<const YamlNode> value;
};

/// Parses a text that read_source accepted; null if no tree can be built. Reports:
///   yaml-syntax    what the parser reports; a second document; an alias inside the value it refers to
///   duplicate-key  at the second of the two; the first is used
///   wrong-type     a key that isn't a scalar, a tag such as `!!float`
///   too-large      nested more than 64 deep, more than a million nodes with aliases expanded, or more than
///                  ten thousand anchors
///   empty-file     nothing but comments
std::shared_ptr<const YamlNode> parse_yaml(const std::string& text, const std::string& file,
                                           scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
