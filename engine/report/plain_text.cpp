#include "engine/report/plain_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "scene/base/utf8.h"

namespace campuswalk::engine {

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

/// Bytes of the white space that the line begins with, as GitHub's runner trims it (.NET's String.TrimStart).
std::size_t size_of_spaces(std::string_view line) {
    std::size_t at = 0;
    while (at < line.size()) {
        const std::size_t bytes = scene::utf8_length(line, at);
        const char32_t code = bytes > 0 ? scene::code_point(line.substr(at, bytes)) : U'x';
        const bool space = (code >= 0x09 && code <= 0x0D) || code == 0x20 || code == 0x85 || code == 0xA0 ||
                           code == 0x1680 || (code >= 0x2000 && code <= 0x200B) || code == 0x2028 ||
                           code == 0x2029 || code == 0x202F || code == 0x205F || code == 0x3000 ||
                           code == 0xFEFF;
        if (!space) {
            break;
        }
        at += bytes;
    }
    return at;
}

/// `change` gets each line without its end and returns it as it shall be.
template <typename Change>
std::string map_lines(std::string_view text, const Change& change) {
    std::string out;
    std::size_t start = 0;
    for (std::size_t end = 0; (end = text.find('\n', start)) != std::string_view::npos; start = end + 1) {
        out += change(text.substr(start, end - start)) + '\n';
    }
    return out + change(text.substr(start));
}

/// Replaces each `#` that begins one of Azure's or GitHub's markers.
std::string without_markers(std::string_view text, std::string_view escape) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = text.substr(i);
        if (rest.starts_with("##[") || rest.starts_with("##vso[")) {
            out += escape;
        } else {
            out += text[i];
        }
    }
    return out;
}

/// `escape` appends the representation of a character, given as its code point and its bytes.
template <typename Escape>
std::string map_characters(std::string_view text, const Escape& escape) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = scene::utf8_length(text, 0);
        if (bytes == 0) {
            out += kReplacement;
        } else {
            escape(scene::code_point(text.substr(0, bytes)), text.substr(0, bytes), out);
        }
        text.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    return map_characters(text, [](char32_t code, std::string_view bytes, std::string& out) {
        if (!scene::controls_display(code)) {
            out += bytes;
        } else if (code == '\n') {
            out += "\\n";
        } else {
            out += code < 0x100 ? "\\x" + hex_digits(code, 2) : u_escape(code);
        }
    });
}

std::string printable_json(std::string_view json) {
    const std::string escaped =
        map_characters(json, [](char32_t code, std::string_view bytes, std::string& out) {
            const bool layout = code == '\n';  // in strings it is escaped already
            out += scene::controls_display(code) && !layout ? u_escape(code) : bytes;
        });
    return without_markers(escaped, "\\u0023");
}

std::string without_ci_commands(std::string_view text) {
    return map_lines(text, [](std::string_view line) {
        const std::size_t start = size_of_spaces(line);
        std::string out(line.substr(0, start));
        std::string_view rest = line.substr(start);
        if (rest.starts_with("::") || rest.starts_with("##")) {
            out += rest.front() == ':' ? "\\x3a" : "\\x23";
            rest.remove_prefix(1);
        }
        return out + without_markers(rest, "\\x23");
    });
}

std::string github_escaped(std::string_view text, bool in_property) {
    std::string out;
    for (const char c : without_ci_commands(map_lines(text, printable))) {
        switch (c) {
            case '%':
                out += "%25";
                break;
            case '\n':
                out += "%0A";
                break;
            case ':':
                out += in_property ? "%3A" : ":";
                break;
            case ',':
                out += in_property ? "%2C" : ",";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string xml_characters(std::string_view text) {
    return map_characters(text, [](char32_t code, std::string_view bytes, std::string& out) {
        const bool space = code == '\t' || code == '\n' || code == '\r';
        const bool refused = (code < 0x20 && !space) || code == 0xfffe || code == 0xffff;
        out += refused ? kReplacement : bytes;
    });
}

std::string valid_utf8(std::string_view text) {
    return map_characters(text, [](char32_t, std::string_view bytes, std::string& out) { out += bytes; });
}

}  // namespace campuswalk::engine
