#include "engine/report/plain_text.h"

#include <algorithm>
#include <cstddef>

#include "scene/base/utf8.h"

namespace campuswalk::engine {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The code point of a valid character.
char32_t code_of(std::string_view character) {
    const auto lead = static_cast<unsigned char>(character.front());
    char32_t code = character.size() == 1 ? lead : lead & (0x7fU >> character.size());
    for (const char byte : character.substr(1)) {
        code = (code << 6U) | (static_cast<unsigned char>(byte) & 0x3fU);
    }
    return code;
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
            escape(code_of(text.substr(0, bytes)), text.substr(0, bytes), out);
        }
        text.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    return map_characters(text, [](char32_t code, std::string_view bytes, std::string& out) {
        constexpr std::string_view kHex = "0123456789abcdef";
        if (code == '\n') {
            out += "\\n";
        } else if (code < 0x20 || (code >= 0x7f && code < 0xa0)) {
            out += {'\\', 'x', kHex[code >> 4U], kHex[code & 15U]};
        } else if (code == 0x2028 || code == 0x2029) {
            out += code == 0x2028 ? "\\u2028" : "\\u2029";
        } else {
            out += bytes;
        }
    });
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
