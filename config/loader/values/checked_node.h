#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "config/loader/values/number.h"
#include "config/loader/yaml/yaml_tree.h"
#include "scene/base/diagnostic.h"
#include "scene/base/texts_of.h"

namespace campuswalk::config {

/// A keyword of the YAML and its value.
template <typename Value>
struct Choice {
    std::string_view name;
    Value value{};
};

/// A node and the list that its diagnostics go to. Each reader below returns a valid value, or nullopt after
/// reporting an error (wrong-type, bad-value) at the node's line and column; callers needn't check again.
/// Copies are cheap; they must not outlive the YamlFile they come from.
class CheckedNode {
public:
    /// `what` names the node in messages, as in "'radius'" or "a step".
    CheckedNode(const YamlNode& node, std::string what, const std::string& file,
                scene::DiagnosticList& diagnostics)
        : node_(&node), what_(std::move(what)), file_(&file), diagnostics_(&diagnostics) {}

    const std::string& what() const { return what_; }
    const YamlNode& node() const { return *node_; }
    const std::string& file() const { return *file_; }
    scene::SourceMark mark() const { return {*file_, node_->line, node_->column}; }
    void diagnose(scene::DiagnosticCode code, std::string message) const;
    scene::DiagnosticList& diagnostics() const { return *diagnostics_; }

    bool is_null() const { return node_->kind == YamlNode::Kind::null; }
    bool is_scalar() const { return node_->kind == YamlNode::Kind::scalar; }
    bool is_sequence() const { return node_->kind == YamlNode::Kind::sequence; }
    bool is_map() const { return node_->kind == YamlNode::Kind::map; }

    /// Any scalar, as written; control characters other than line breaks and tabs are errors.
    std::optional<std::string> text() const;
    /// The same, but a single line and not empty.
    std::optional<std::string> line() const;
    std::optional<double> number(const Range& range) const;
    std::optional<int> as_int(int min, int max) const;
    std::optional<bool> as_bool() const;
    /// `[x, y, z, w]`, each within the range.
    std::optional<Eigen::Vector4d> vector4(const Range& range) const;
    /// `[x, y, z]`, each within the range.
    std::optional<Eigen::Vector3d> vector(const Range& range) const;

    /// One of the keywords; the error for any other value lists them.
    template <typename Value, std::size_t count>
    std::optional<Value> choice(const std::array<Choice<Value>, count>& choices) const {
        const std::optional<std::size_t> index = one_of(scene::texts_of(choices, &Choice<Value>::name));
        return index ? std::optional<Value>(choices[*index].value) : std::nullopt;
    }
    std::optional<std::size_t> one_of(const std::vector<std::string>& names) const;

    /// The entries of a list, each called `what` in messages; reports anything but a list. A section that is
    /// left empty (`places:` with nothing below) is an empty list.
    std::vector<CheckedNode> items(const std::string& what) const;
    /// A list, or a single scalar as a list of one.
    std::vector<CheckedNode> items_or_one(const std::string& what) const;

    struct Entry;
    /// The entries of a map in the file's order; reports anything but a map. Empty sections as in `items`.
    std::vector<Entry> entries() const;

private:
    /// Reports anything but a scalar; `expected` says what it must be, as in "a number".
    bool require_scalar(std::string_view expected) const;
    bool numbers(const Range& range, std::span<double> value, const char* shape) const;
    CheckedNode child(const YamlNode& node, std::string what) const {
        return {node, std::move(what), *file_, *diagnostics_};
    }

    const YamlNode* node_;
    std::string what_;
    const std::string* file_;
    scene::DiagnosticList* diagnostics_;
};

struct CheckedNode::Entry {
    std::string key;
    scene::SourceMark key_mark;
    CheckedNode value;
};

}  // namespace campuswalk::config
