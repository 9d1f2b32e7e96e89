#include "config/loader/yaml_tree.h"

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

#include "config/loader/complaint_limit.h"
#include "config/loader/text_positions.h"
#include "config/loader/wording.h"
#include "config/loader/yaml_syntax.h"

namespace campuswalk::config {
namespace {

using scene::DiagnosticList;
using scene::SourceMark;

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::size_t kMostAnchors = 10'000;

/// Stops the parser at something that makes the rest of the file pointless.
struct Refusal {
    YAML::Mark mark = {};
    const char* code = "";
    const char* message = "";
};

/// Builds the tree from the parser's events. The parser's own node class is not used: it forgets where
/// aliases and empty values stand, keeps the last of two equal keys and ignores a second document.
class TreeBuilder final : public YAML::EventHandler {
public:
    TreeBuilder(std::string_view text, const TextPositions& positions, std::string file,
                DiagnosticList& diagnostics)
        : text_(text), positions_(positions), file_(std::move(file)), diagnostics_(diagnostics) {}

    std::shared_ptr<const YamlNode> root;

    /// Where the innermost map or list starts that is not yet complete.
    std::optional<YAML::Mark> innermost_start() const {
        return open_.empty() ? std::nullopt : std::optional(open_.back().mark);
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0) {
            throw Refusal{mark, "yaml-syntax",
                          "text after the end of the document: a stray bracket, less indentation than "
                          "above, or a second '---'"};
        }
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(leaf(YamlNode::Kind::null, positions_.of_null(mark.pos)), anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        refuse_tag(mark, tag);
        auto node = leaf(YamlNode::Kind::scalar, positions_.of(mark.pos));
        node->text = value;
        node->quoted = tag == "!";
        if (node->quoted && is_quote_unclosed(text_, static_cast<std::size_t>(mark.pos))) {
            throw Refusal{mark, "yaml-syntax", "this quote is never closed"};
        }
        node->text_column = text_column(static_cast<std::size_t>(mark.pos), value);
        add(std::move(node), anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) {
            throw Refusal{mark, "yaml-syntax", "an alias inside what it names; write the value out"};
        }
        place(found->second, positions_.of(mark.pos));
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
        TextPosition at;
        bool kept = true;
    };
    struct Open {
        std::shared_ptr<YamlNode> node;
        YAML::anchor_t anchor = 0;
        YAML::Mark mark;
        std::optional<Key> key;                 ///< map: the key whose value comes next
        std::map<std::string, int> lines = {};  ///< map: of the keys so far
    };

    SourceMark mark_at(const TextPosition& at) const { return {file_, at.line, at.column}; }

    static std::shared_ptr<YamlNode> leaf(YamlNode::Kind kind, const TextPosition& at) {
        auto node = std::make_shared<YamlNode>();
        node->kind = kind;
        node->line = at.line;
        node->column = at.column;
        return node;
    }

    /// 0 for what is escaped, folded or a block.
    int text_column(std::size_t at, const std::string& value) const {
        const bool quote = at < text_.size() && (text_[at] == '"' || text_[at] == '\'');
        const std::size_t start = at + (quote ? 1 : 0);
        const bool as_it_is = start < text_.size() && text_.substr(start, value.size()) == value;
        return as_it_is && value.find('\n') == std::string::npos
                   ? positions_.of(static_cast<int>(start)).column
                   : 0;
    }

    void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
        if (tag != "?" && tag != "!" && !tag.empty()) {
            add_diagnostic(diagnostics_, mark_at(positions_.of(mark.pos)), "wrong-type",
                           "tags are not used here; remove the word with the '!'");
        }
    }

    void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        if (open_.size() >= kDeepest) {
            throw Refusal{mark, "too-large", "nested more than 64 deep"};
        }
        refuse_tag(mark, tag);
        open_.push_back({leaf(kind, positions_.of(mark.pos)), anchor, mark, std::nullopt});
    }

    void close() {
        Open done = std::move(open_.back());
        open_.pop_back();
        add(done.node, done.anchor);
    }

    /// Puts a finished node where it belongs and lets aliases name it.
    void add(std::shared_ptr<const YamlNode> node, YAML::anchor_t anchor) {
        if (anchor != 0) {
            if (anchors_.size() >= kMostAnchors) {
                throw Refusal{{}, "too-large", "more than ten thousand names for references ('&')"};
            }
            anchors_[anchor] = node;
        }
        const TextPosition at{node->line, node->column};
        place(std::move(node), at);
    }

    /// `at` is where the node, or the alias for it, stands.
    void place(std::shared_ptr<const YamlNode> node, const TextPosition& at) {
        if (open_.empty()) {
            root = std::move(node);
            return;
        }
        Open& parent = open_.back();
        parent.node->size += std::min(node->size, kMostNodes);  // cannot overflow: the file is small
        if (parent.node->size > kMostNodes) {
            throw Refusal{parent.mark, "too-large", "more than a million values (aliases count in full)"};
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

    Key as_key(Open& map, const YamlNode& node, const TextPosition& at) {
        if (node.kind != YamlNode::Kind::scalar) {
            add_diagnostic(diagnostics_, mark_at(at), "wrong-type",
                           "a key must be a word, as in 'title: Library'");
            return {"", at, false};
        }
        const auto [earlier, fresh] = map.lines.emplace(node.text, at.line);
        if (!fresh) {
            add_diagnostic(diagnostics_, mark_at(at), "duplicate-key",
                           "key " + in_quotes(node.text) + " was given on line " +
                               std::to_string(earlier->second) + " already; remove one of the two");
        }
        return {node.text, at, fresh};
    }

    static void add_value(Open& map, std::shared_ptr<const YamlNode> value) {
        const Key key = *std::exchange(map.key, std::nullopt);
        if (!key.kept) {
            return;
        }
        if (value->kind == YamlNode::Kind::null && value->line != key.at.line) {
            value = leaf(YamlNode::Kind::null, key.at);  // the parser puts it at the next key
        }
        map.node->entries.push_back({key.text, key.at.line, key.at.column, std::move(value)});
    }

    std::string_view text_;
    const TextPositions& positions_;
    std::string file_;
    DiagnosticList& diagnostics_;
    int documents_ = 0;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, std::shared_ptr<const YamlNode>> anchors_;
};

}  // namespace

std::shared_ptr<const YamlNode> parse_yaml(const std::string& text, const std::string& file,
                                           DiagnosticList& diagnostics) {
    const TextPositions positions(text);
    TreeBuilder builder(text, positions, file, diagnostics);
    const auto diagnose = [&](const YAML::Mark& mark, const char* code, const std::string& message) {
        const TextPosition at = mark.is_null() ? TextPosition{} : positions.of(mark.pos);
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
        return diagnose(refusal.mark, refusal.code, refusal.message);
    } catch (const YAML::Exception& error) {
        const bool bracket =
            error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW || error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW;
        const YAML::Mark mark = bracket ? builder.innermost_start().value_or(error.mark) : error.mark;
        return diagnose(mark, "yaml-syntax", explained(error.msg));
    }
    if (!builder.root || builder.root->kind == YamlNode::Kind::null) {
        diagnostics.error({file, 0, 0}, "empty-file", "there is nothing in this file but comments or spaces");
        return nullptr;
    }
    return builder.root;
}

}  // namespace campuswalk::config
