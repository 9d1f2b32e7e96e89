#pragma once

#include <cstddef>
#include <string_view>

namespace campuswalk::scene {

/// Whether the byte is one of a UTF-8 character's after the first.
constexpr bool is_utf8_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Bytes of the UTF-8 character that starts at `at`; 0 if none does (overlong forms, surrogates and truncated
/// characters are invalid).
constexpr std::size_t utf8_length(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    if (lead < 0x80) {
        return 1;
    }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() - at < length) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if (!is_utf8_continuation(text[at + i])) {
            return 0;
        }
    }
    const auto second = static_cast<unsigned char>(text[at + 1]);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool outside = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
    return overlong || outside ? 0 : length;
}

constexpr bool is_utf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t bytes = utf8_length(text, at);
        if (bytes == 0) {
            return false;
        }
        at += bytes;
    }
    return true;
}

/// Of a character whose bytes utf8_length() has found to be one.
constexpr char32_t code_point(std::string_view character) {
    const auto lead = static_cast<unsigned char>(character.front());
    char32_t code = character.size() == 1 ? lead : lead & (0x7FU >> character.size());
    for (const char byte : character.substr(1)) {
        code = (code << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    return code;
}

/// Whether a character changes how those around it are shown instead of being shown itself: control
/// characters of ASCII and C1, which terminals obey, the marks of bidirectional text, which reorder a line
/// ("Trojan Source", CVE-2021-42574), line separators, byte order marks and tags.
constexpr bool controls_display(char32_t code) {
    const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
    return code < 0x20 || within(0x7F, 0x9F) || code == 0x061C || within(0x200E, 0x200F) ||
           within(0x2028, 0x202E) || within(0x2066, 0x2069) || code == 0xFEFF || within(0xFFF9, 0xFFFB) ||
           within(0xE0000, 0xE007F);
}

}  // namespace campuswalk::scene
