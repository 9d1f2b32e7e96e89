#include "config/loader/json/json_tree.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/utf8.h"

namespace campuswalk::config {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxJsonDepth = 64;
constexpr std::size_t kMaxJsonValues = 1'000'000;

/// The text's bytes for the parser, which doesn't say where what it reports is: how far it has read does.
class ReportingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    ReportingIterator(const char* at, const char*& read_to) : at_(at), read_to_(&read_to) {}

    reference operator*() const { return *at_; }
    ReportingIterator& operator++() {
        *read_to_ = ++at_;
        return *this;
    }
    ReportingIterator operator++(int) {
        const ReportingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const ReportingIterator& a, const ReportingIterator& b) { return a.at_ == b.at_; }

private:
    const char* at_;
    const char** read_to_;
};

/// Lines and columns of ascending places in a text.
class PlaceInText {
public:
    explicit PlaceInText(std::string_view text) : text_(text) {}

    /// Line and column, from 1; `to` is never before an earlier one.
    std::pair<int, int> advance(std::size_t to) {
        for (; at_ < std::min(to, text_.size()); ++at_) {
            const char c = text_[at_];
            line_ += c == '\n' ? 1 : 0;
            column_ = c == '\n' ? 1 : column_ + (scene::is_utf8_continuation(c) ? 0 : 1);
        }
        return {line_, column_};
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    int column_ = 1;
};

/// Of "[json.exception…] parse error at line 1, column 2: WORDS; last read: 'BYTES'" only the words: the
/// bytes may be any, and as many as there are.
std::string in_our_words(std::string_view parser_message) {
    const std::size_t colon = parser_message.find(": ");
    if (colon == std::string_view::npos) {
        return "a number is out of range";
    }
    const std::string_view words = parser_message.substr(colon + 2);
    return std::string(words.substr(0, words.find("; last read")));
}

/// Builds the tree from the parser's events; each returns whether to read on.
class JsonTreeBuilder final : public json::json_sax_t {
public:
    JsonTreeBuilder(std::string_view text, std::string file, scene::DiagnosticList& diagnostics)
        : text_(text),
          file_(std::move(file)),
          diagnostics_(diagnostics),
          place_(text),
          read_to_(text.data()) {}

    std::shared_ptr<const YamlNode> root;

    ReportingIterator begin() { return {text_.data(), read_to_}; }
    ReportingIterator end() { return {text_.data() + text_.size(), read_to_}; }

    bool null() override { return add(leaf(YamlNode::Kind::null)); }
    bool boolean(bool value) override { return add_scalar(value ? "true" : "false", false); }
    bool number_integer(std::int64_t) override { return add_number(); }
    bool number_unsigned(std::uint64_t) override { return add_number(); }
    bool number_float(double, const std::string&) override { return add_number(); }
    bool string(std::string& value) override { return add_scalar(std::move(value), true); }
    bool binary(json::binary_t&) override { return false; }  // not in JSON

    bool start_object(std::size_t) override { return open(YamlNode::Kind::map); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(YamlNode::Kind::sequence); }
    bool end_array() override { return close(); }

    bool key(std::string& key) override {
        const std::shared_ptr<YamlNode> at = leaf(YamlNode::Kind::scalar);
        Open& map = open_.back();
        const auto [first, is_new] = map.lines.emplace(key, at->line);
        if (!is_new) {
            add_diagnostic(diagnostics_, {file_, at->line, at->column}, "duplicate-key",
                           "duplicate key " + in_quotes(key) + ", first given on line " +
                               std::to_string(first->second) + "; remove one of the two");
        }
        map.key = {std::move(key), at->line, at->column, nullptr};
        map.keeps_value = is_new;
        return !is_full(diagnostics_);
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        const auto read = static_cast<std::size_t>(read_to_ - text_.data());
        const auto [line, column] = place_.advance(read == 0 ? 0 : read - 1);
        return refuse({file_, line, column}, "json-syntax", in_our_words(error.what()));
    }

private:
    struct Open {
        std::shared_ptr<YamlNode> node;
        YamlNode::Entry key = {};               ///< map: the key whose value comes next
        bool keeps_value = true;                ///< map: false after a duplicate key
        std::map<std::string, int> lines = {};  ///< map: the line of each key so far
    };

    bool refuse(const scene::SourceMark& mark, scene::DiagnosticCode code, const std::string& message) {
        add_diagnostic(diagnostics_, mark, code, message);
        root = nullptr;
        return false;
    }

    /// At the value that the parser has just read, or the bracket.
    std::shared_ptr<YamlNode> leaf(YamlNode::Kind kind) {
        // Of a number, the parser has also read what comes after it; that is none of these or a bracket.
        const std::size_t start = std::min(text_.find_first_not_of(" \t\r\n,:", last_end_), text_.size());
        last_start_ = start;
        last_end_ = static_cast<std::size_t>(read_to_ - text_.data());
        auto node = std::make_shared<YamlNode>();
        node->kind = kind;
        std::tie(node->line, node->column) = place_.advance(start);
        return node;
    }

    bool add_scalar(std::string text, bool quoted) {
        const std::shared_ptr<YamlNode> node = leaf(YamlNode::Kind::scalar);
        node->text = std::move(text);
        node->quoted = quoted;
        return add(node);
    }

    /// As it is written: what is a number in JSON is one in YAML.
    bool add_number() {
        const std::shared_ptr<YamlNode> node = leaf(YamlNode::Kind::scalar);
        const std::string_view rest = text_.substr(last_start_);
        node->text = rest.substr(0, rest.find_first_not_of("0123456789+-.eE"));
        return add(node);
    }

    bool open(YamlNode::Kind kind) {
        std::shared_ptr<YamlNode> node = leaf(kind);
        if (open_.size() >= kMaxJsonDepth) {
            return refuse({file_, node->line, node->column}, "too-large", "nested more than 64 levels deep");
        }
        open_.push_back({std::move(node)});
        return true;
    }

    bool close() {
        last_end_ = static_cast<std::size_t>(read_to_ - text_.data());
        const std::shared_ptr<YamlNode> done = std::move(open_.back().node);
        open_.pop_back();
        return add(done);
    }

    bool add(const std::shared_ptr<YamlNode>& node) {
        if (++values_ > kMaxJsonValues) {
            return refuse({file_, node->line, node->column}, "too-large", "more than a million values");
        }
        if (open_.empty()) {
            root = node;
            return true;
        }
        Open& parent = open_.back();
        parent.node->size += node->size;
        if (parent.node->kind == YamlNode::Kind::sequence) {
            parent.node->items.push_back(node);
        } else if (parent.keeps_value) {
            parent.key.value = node;
            parent.node->entries.push_back(std::move(parent.key));
        }
        return true;
    }

    std::string_view text_;
    std::string file_;
    scene::DiagnosticList& diagnostics_;
    PlaceInText place_;
    const char* read_to_;         ///< the parser has read all before it
    std::size_t last_start_ = 0;  ///< of the last value
    std::size_t last_end_ = 0;    ///< behind the last value or bracket, and what was read with it
    std::size_t values_ = 0;
    std::vector<Open> open_;
};

}  // namespace

std::shared_ptr<const YamlNode> parse_json(std::string_view text, const std::string& file,
                                           scene::DiagnosticList& diagnostics) {
    JsonTreeBuilder builder(text, file, diagnostics);
    const bool complete = json::sax_parse(builder.begin(), builder.end(), &builder);
    return complete ? builder.root : nullptr;
}

}  // namespace campuswalk::config
