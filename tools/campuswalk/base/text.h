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

/// The text without the ending; all of it if it ends otherwise or is nothing else.
inline std::string without_ending(std::string text, std::string_view ending) {
    if (text.size() > ending.size() && text.ends_with(ending)) {
        text.resize(text.size() - ending.size());
    }
    return text;
}

}  // namespace campuswalk::tools
