#include "scene/base/printable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "scene/base/ascii.h"
#include "scene/base/unicode_words.h"
#include "scene/base/utf8.h"

namespace campuswalk::scene {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The last digits of a number in hexadecimal.
std::string hex_digits(std::uint32_t number, unsigned digits) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string text;
    while (digits-- > 0) {
        text += kHex[number >> (4 * digits) & 15U];
    }
    return text;
}

/// As JSON, C++ and Python write it; beyond U+FFFF as a pair of surrogates.
std::string u_escape(char32_t code) {
    if (code > 0xFFFF) {
        const char32_t offset = code - 0x10000;
        return "\\u" + hex_digits(0xD800 + (offset >> 10U), 4) + "\\u" +
               hex_digits(0xDC00 + (offset & 0x3FFU), 4);
    }
    return "\\u" + hex_digits(code, 4);
}

std::string x_escape(char32_t code) {
    return code < 0x100 ? "\\x" + hex_digits(code, 2) : u_escape(code);
}

std::string_view without_leading(std::string_view text, bool (*is_skipped)(char)) {
    return text.substr(static_cast<std::size_t>(std::ranges::find_if_not(text, is_skipped) - text.begin()));
}

bool is_word_letter(char c) {
    return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.' || c == ' ';
}

/// `##[`, `##WORD[` or `[[WORD|`. JSON's own layout has neither.
bool begins_marker(std::string_view text) {
    if (text.starts_with("##")) {
        return without_leading(text.substr(2), is_word_letter).starts_with('[');
    }
    return text.starts_with("[[") && without_leading(text.substr(2), is_word_letter).starts_with('|');
}

/// Whether GitHub's runner takes a line for a command. It ignores spaces before the colons.
bool begins_command(std::string_view line) {
    return without_leading(line, [](char c) { return c == ' '; }).starts_with("::");
}

/// `escape` returns the escape of a character that must have one. `stays` says which of them are the layout's
/// own.
template <typename Escape, typename Stays>
std::string escaped(std::string_view text, const Escape& escape, const Stays& stays) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = utf8_length(text, 0);
        const char32_t code = bytes == 0 ? 0 : code_point(text.substr(0, bytes));
        if (bytes == 0) {
            out += kReplacement;
        } else if (!stays(code) && (is_unseen(code) || begins_marker(text))) {
            out += escape(code);
        } else {
            out += text.substr(0, bytes);
        }
        text.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string line = escaped(
        text, [](char32_t code) { return code == '\n' ? "\\n" : x_escape(code); },
        [](char32_t) { return false; });
    if (begins_command(line)) {
        line.replace(line.find(':'), 1, x_escape(':'));
    }
    return line;
}

std::string printable_json(std::string_view json) {
    return escaped(json, u_escape, [](char32_t code) { return code == '\n'; });  // escaped in strings
}

}  // namespace campuswalk::scene
