#include "config/loader/yaml/yaml_tree.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"
#include "config/loader/yaml/yaml_syntax.h"
#include "scene/base/utf8.h"

namespace campuswalk::config {
namespace {

using scene::DiagnosticList;
using scene::SourceMark;

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxNodes = 1'000'000;
// Long texts that aliases repeat would take gigabytes.
constexpr std::size_t kLettersOfAValue = 64;
constexpr std::size_t kMaxAnchors = 10'000;

/// Thrown to stop the parser at an error after which reading on is pointless.
struct Refusal {
    YAML::Mark mark = {};
    scene::DiagnosticCode code;
    const char* message = "";
};

/// Lines and columns count from 1; 0 is the whole file.
struct Position {
    int line = 0;
    int column = 0;
};

/// yaml-cpp counts from 0, and bytes where editors count characters.
Position position_of(std::string_view text, const YAML::Mark& mark) {
    if (mark.is_null()) {
        return {};
    }
    constexpr std::size_t kMaxLineBytes = 1000;  // bytes whose characters are counted: a file may be one line
    const auto column = static_cast<std::size_t>(mark.column);
    const std::size_t start = std::min(static_cast<std::size_t>(mark.pos) - column, text.size());
    const std::string_view before = text.substr(start, std::min(column, kMaxLineBytes));
    const auto continuation_bytes = std::ranges::count_if(before, scene::is_utf8_continuation);
    return {mark.line + 1, mark.column + 1 - static_cast<int>(continuation_bytes)};
}

/// Builds the tree from the parser's events. YAML::Node is not used: it loses the positions of aliases and
/// empty values, keeps the last of two equal keys and ignores a second document.
class TreeBuilder final : public YAML::EventHandler {
public:
    TreeBuilder(std::string_view text, std::string file, DiagnosticList& diagnostics)
        : text_(text), file_(std::move(file)), diagnostics_(diagnostics) {}

    std::shared_ptr<const YamlNode> root;

    /// Where the innermost unfinished map or list starts.
    std::optional<YAML::Mark> innermost_start() const {
        return open_.empty() ? std::nullopt : std::optional(open_.back().mark);
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0) {
            throw Refusal{mark, "yaml-syntax",
                          "unexpected text after the end of the document: a stray bracket, too little "
                          "indentation, or a second '---'"};
        }
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(leaf(YamlNode::Kind::null, position_of_null(mark)), anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        refuse_tag(mark, tag);
        auto node = leaf(YamlNode::Kind::scalar, position_of(text_, mark));
        node->text = value;
        node->size += value.size() / kLettersOfAValue;
        node->quoted = tag == "!";
        if (node->quoted && is_quote_unclosed(text_, static_cast<std::size_t>(mark.pos))) {
            throw Refusal{mark, "yaml-syntax", "this quote is never closed"};
        }
        add(std::move(node), anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) {
            throw Refusal{mark, "yaml-syntax",
                          "this alias refers to a value that contains it; write the value out"};
        }
        place(found->second, position_of(text_, mark));
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(YamlNode::Kind::sequence, mark, tag, anchor);
    }
    void OnSequenceEnd() override { close(); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(YamlNode::Kind::map, mark, tag, anchor);
    }
    void OnMapEnd() override { close(); }

private:
    struct Key {
        std::string text;
        Position at;
        bool is_first = true;  ///< false: a duplicate
    };
    struct Open {
        std::shared_ptr<YamlNode> node;
        YAML::anchor_t anchor = 0;
        YAML::Mark mark;
        std::optional<Key> key;                 ///< map: the key whose value comes next
        std::map<std::string, int> lines = {};  ///< map: the line of each key so far
    };

    SourceMark mark_at(const Position& at) const { return {file_, at.line, at.column}; }

    static std::shared_ptr<YamlNode> leaf(YamlNode::Kind kind, const Position& at) {
        auto node = std::make_shared<YamlNode>();
        node->kind = kind;
        node->line = at.line;
        node->column = at.column;
        return node;
    }

    /// The parser places an empty list entry at the next token, maybe lines below; this is its own '-'
    /// instead.
    Position position_of_null(const YAML::Mark& mark) const {
        const bool in_list = !open_.empty() && open_.back().node->kind == YamlNode::Kind::sequence;
        const auto at = std::min(static_cast<std::size_t>(mark.pos), text_.size());
        const std::string_view rest = text_.substr(at);
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\n,]}"));
        const bool is_written = word == "~" || word == "null" || word == "Null" || word == "NULL" ||
                                rest.starts_with(',') || rest.starts_with(']');
        const std::size_t dash = in_list && !is_written && at > 0 ? text_.rfind('-', at - 1) : text_.npos;
        if (dash == text_.npos) {
            return position_of(text_, mark);
        }
        const std::size_t start = text_.rfind('\n', dash) + 1;  // npos + 1 is 0
        const auto gap = text_.substr(dash, at - dash);
        const auto lines = static_cast<int>(std::ranges::count(gap, '\n'));
        return {mark.line + 1 - lines, static_cast<int>(dash - start) + 1};
    }

    void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
        if (tag != "?" && tag != "!" && !tag.empty()) {
            add_diagnostic(diagnostics_, mark_at(position_of(text_, mark)), "wrong-type",
                           "tags aren't supported; remove the '!' and its word");
        }
    }

    void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        if (open_.size() >= kMaxDepth) {
            throw Refusal{mark, "too-large", "nested more than 64 levels deep"};
        }
        refuse_tag(mark, tag);
        open_.push_back({leaf(kind, position_of(text_, mark)), anchor, mark, std::nullopt});
    }

    void close() {
        Open done = std::move(open_.back());
        open_.pop_back();
        add(done.node, done.anchor);
    }

    /// Adds a finished node to its parent, and to the anchors that aliases may refer to.
    void add(std::shared_ptr<const YamlNode> node, YAML::anchor_t anchor) {
        if (anchor != 0) {
            if (anchors_.size() >= kMaxAnchors) {
                throw Refusal{{}, "too-large", "more than 10,000 anchors ('&')"};
            }
            anchors_[anchor] = node;
        }
        const Position at{node->line, node->column};
        place(std::move(node), at);
    }

    /// `at` is the position of the node or of the alias for it.
    void place(std::shared_ptr<const YamlNode> node, const Position& at) {
        if (open_.empty()) {
            root = std::move(node);
            return;
        }
        Open& parent = open_.back();
        parent.node->size += std::min(node->size, kMaxNodes);  // cannot overflow: the file is small
        if (parent.node->size > kMaxNodes) {
            throw Refusal{
                parent.mark, "too-large",
                "more than a million values (each alias counts in full, and 64 letters as a value)"};
        }
        if (is_full(diagnostics_)) {
            throw Refusal{};
        }
        if (parent.node->kind == YamlNode::Kind::sequence) {
            parent.node->items.push_back(std::move(node));
        } else if (!parent.key) {
            parent.key = as_key(parent, *node, at);
        } else {
            add_value(parent, std::move(node));
        }
    }

    Key as_key(Open& map, const YamlNode& node, const Position& at) {
        if (node.kind != YamlNode::Kind::scalar) {
            add_diagnostic(diagnostics_, mark_at(at), "wrong-type",
                           "a key must be a word, as in 'title: Library'");
            return {"", at, false};
        }
        const auto [first, is_new] = map.lines.emplace(node.text, at.line);
        if (!is_new) {
            add_diagnostic(diagnostics_, mark_at(at), "duplicate-key",
                           "duplicate key " + in_quotes(node.text) + ", first given on line " +
                               std::to_string(first->second) + "; remove one of the two");
        }
        return {node.text, at, is_new};
    }

    static void add_value(Open& map, std::shared_ptr<const YamlNode> value) {
        const Key key = *std::exchange(map.key, std::nullopt);
        if (!key.is_first) {
            return;
        }
        if (value->kind == YamlNode::Kind::null && value->line != key.at.line) {
            value = leaf(YamlNode::Kind::null, key.at);  // the parser places it at the next key
        }
        map.node->entries.push_back({key.text, key.at.line, key.at.column, std::move(value)});
    }

    std::string_view text_;
    std::string file_;
    DiagnosticList& diagnostics_;
    int documents_ = 0;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, std::shared_ptr<const YamlNode>> anchors_;
};

}  // namespace

std::shared_ptr<const YamlNode> parse_yaml(const std::string& text, const std::string& file,
                                           DiagnosticList& diagnostics) {
    TreeBuilder builder(text, file, diagnostics);
    const auto fail = [&](const YAML::Mark& mark, scene::DiagnosticCode code, const std::string& message) {
        const Position at = position_of(text, mark);
        add_diagnostic(diagnostics, {file, at.line, at.column}, code, message);
        return nullptr;
    };
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const Refusal& refusal) {
        if (is_full(diagnostics)) {
            return nullptr;
        }
        return fail(refusal.mark, refusal.code, refusal.message);
    } catch (const YAML::Exception& error) {
        const bool bracket =
            error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW || error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW;
        const YAML::Mark mark = bracket ? builder.innermost_start().value_or(error.mark) : error.mark;
        return fail(mark, "yaml-syntax", explained(error.msg));
    }
    if (!builder.root || builder.root->kind == YamlNode::Kind::null) {
        diagnostics.error({file, 0, 0}, "empty-file", "the file is empty or contains only comments");
        return nullptr;
    }
    return builder.root;
}

}  // namespace campuswalk::config
