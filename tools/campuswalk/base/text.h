#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::tools {

inline std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) {
        text.append(&word == &words.front() ? "" : between).append(word);
    }
    return text;
}

/// The parts between the separators, at least one; they may be empty. They are views of `text`.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
        parts.push_back(text.substr(0, at));
        text.remove_prefix(at + 1);
    }
    parts.push_back(text);
    return parts;
}

/// One word of a shell's command line, whatever is in it.
inline std::string shell_quoted(std::string_view text) {
    std::string word = "'";
    for (const char c : text) {
        word += c == '\'' ? std::string_view("'\\''") : std::string_view(&c, 1);
    }
    return word + "'";
}

/// The same in quotes only where a shell would take it for something else.
inline std::string shell_word(const std::string& text) {
    const bool plain = text.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                           "._/-+=:,@%") == std::string::npos;
    return plain && !text.empty() ? text : shell_quoted(text);
}

/// The text without the ending; unchanged if it ends differently or is only the ending.
inline std::string without_ending(std::string text, std::string_view ending) {
    if (text.size() > ending.size() && text.ends_with(ending)) {
        text.resize(text.size() - ending.size());
    }
    return text;
}

}  // namespace campuswalk::tools
