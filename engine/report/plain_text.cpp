#include "engine/report/plain_text.h"

#include <cstddef>
#include <functional>

namespace campuswalk::engine {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

constexpr bool is_tail(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

/// A character as its code and the bytes it takes; no bytes where there is none.
struct Character {
    char32_t code = 0;
    std::size_t bytes = 0;
};

Character decode(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    if (bytes == 0 || lead > 0xf4 || text.size() < bytes) {
        return {};
    }
    char32_t code = bytes == 1 ? lead : lead & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!is_tail(text[i])) {
            return {};
        }
        code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3fU);
    }
    const bool overlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return overlong || surrogate || code > 0x10ffff ? Character{} : Character{code, bytes};
}

/// `spell` appends what stands for a character.
std::string respelled(std::string_view text,
                      const std::function<void(const Character&, std::string_view, std::string&)>& spell) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Character character = decode(text);
        if (character.bytes == 0) {
            out += kReplacement;
            text.remove_prefix(1);
            continue;
        }
        spell(character, text.substr(0, character.bytes), out);
        text.remove_prefix(character.bytes);
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    return respelled(text, [](const Character& character, std::string_view bytes, std::string& out) {
        constexpr std::string_view kHex = "0123456789abcdef";
        const char32_t code = character.code;
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
    return respelled(text, [](const Character& character, std::string_view bytes, std::string& out) {
        const char32_t code = character.code;
        const bool space = code == '\t' || code == '\n' || code == '\r';
        const bool refused = (code < 0x20 && !space) || code == 0xfffe || code == 0xffff;
        out += refused ? kReplacement : bytes;
    });
}

std::string valid_utf8(std::string_view text) {
    return respelled(text, [](const Character&, std::string_view bytes, std::string& out) { out += bytes; });
}

}  // namespace campuswalk::engine
