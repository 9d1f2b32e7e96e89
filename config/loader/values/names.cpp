#include "config/loader/values/names.h"

#include <algorithm>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/ascii.h"
#include "scene/base/unicode_words.h"

namespace campuswalk::config {

namespace {

bool is_kebab(std::string_view word) {
    const auto allowed = [](char c) { return scene::is_lower(c) || scene::is_digit(c) || c == '-'; };
    return !word.empty() && word.front() != '-' && word.back() != '-' &&
           word.find("--") == std::string_view::npos && std::ranges::all_of(word, allowed);
}

bool is_id_path(std::string_view path) {
    const std::size_t slash = path.find('/');
    return scene::is_id_word(path.substr(0, slash)) &&
           (slash == std::string_view::npos || is_id_path(path.substr(slash + 1)));
}

constexpr const char* kKebabForm = "lower-case letters, digits and single hyphens, such as main-gate";
constexpr const char* kIdForm = "letters and digits of any script, with '-', '_' or '.' between them";
constexpr const char* kPathForm =
    "letters and digits of any script, with '-', '_' or '.' between them and '/' between words, such as "
    "library/door";

std::optional<std::string> checked(const CheckedNode& node, bool (*is_valid)(std::string_view),
                                   const char* form) {
    std::optional<std::string> name = name_in(node);
    if (name && (name->size() > kMaxNameBytes || !is_valid(*name))) {
        node.diagnose("bad-value", node.what() + " must be " + form + ", not " + in_quotes(*name));
        return std::nullopt;
    }
    return name;
}

}  // namespace

std::optional<std::string> kebab_name(const CheckedNode& node) {
    return checked(node, is_kebab, kKebabForm);
}

std::optional<std::string> id_word(const CheckedNode& node) {
    return checked(node, scene::is_id_word, kIdForm);
}

std::optional<std::string> id_path(const CheckedNode& node) {
    return checked(node, is_id_path, kPathForm);
}

std::optional<std::string> name_in(const CheckedNode& node) {
    const std::optional<std::string> name = node.line();
    return name ? std::optional(scene::normalized(*name)) : std::nullopt;
}

std::string id_key(const CheckedNode::Entry& entry) {
    std::string key = scene::normalized(entry.key);
    if (key.size() > kMaxNameBytes || !scene::is_id_word(key)) {
        add_diagnostic(entry.value.diagnostics(), entry.key_mark, "bad-value",
                       "the name must be " + std::string(kIdForm) + ", not " + in_quotes(entry.key));
    }
    return key;
}

void check_kebab_key(const CheckedNode::Entry& entry) {
    if (entry.key.size() > kMaxNameBytes || !is_kebab(entry.key)) {
        add_diagnostic(entry.value.diagnostics(), entry.key_mark, "bad-value",
                       "the name must be " + std::string(kKebabForm) + ", not " + in_quotes(entry.key));
    }
}

void UniqueNames::add(const std::string& name, const CheckedNode& at) {
    if (name.empty()) {
        return;
    }
    const auto [first, is_new] = marks_.emplace(name, at.mark());
    if (!is_new) {
        const scene::SourceMark& mark = first->second;
        at.diagnose("duplicate-name", "duplicate " + thing_ + " " + in_quotes(name) +
                                          ", first given on line " + std::to_string(mark.line) +
                                          (mark.file == at.mark().file ? "" : " of " + mark.file));
    }
}

}  // namespace campuswalk::config
