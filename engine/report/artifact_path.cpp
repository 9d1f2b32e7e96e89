#include "engine/report/artifact_path.h"

#include <algorithm>

#include "scene/base/ascii.h"
#include "scene/base/utf8.h"

namespace campuswalk::engine {

namespace {

/// How many bytes at `at` no path may have there; 0 if they may stay.
std::size_t refused_bytes(std::string_view path, std::size_t at) {
    const std::size_t bytes = scene::utf8_length(path, at);
    if (bytes == 0) {
        return 1;
    }
    const char c = path[at];
    const bool is_drive = c == ':' && at == 1 && scene::is_letter(path[0]);
    const bool is_hidden = c == '.' && (at == 0 || path[at - 1] == '/');  // `..` among them, and `.git`
    const bool is_pair = (c == '[' || c == ']') && at > 0 && path[at - 1] == c;
    const bool refused = c == '\\' || c == '|' || is_drive || is_hidden || is_pair ||
                         scene::controls_display(scene::code_point(path.substr(at, bytes)));
    return refused ? bytes : 0;
}

}  // namespace

std::string percent_encoded(std::string_view bytes) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        text += {'%', kDigits[byte / 16U], kDigits[byte % 16U]};
    }
    return text;
}

bool is_artifact_path(std::string_view path) {
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('/', start), path.size());
        if (end == start) {
            return false;
        }
        start = end + 1;
    }
    for (std::size_t at = 0; at < path.size(); at += scene::utf8_length(path, at)) {
        if (refused_bytes(path, at) > 0) {
            return false;
        }
    }
    return true;
}

std::string to_artifact_path(std::string_view path) {
    std::string text;
    for (std::size_t at = 0; at < path.size();) {
        const bool looks_encoded = path[at] == '%' && path.size() - at > 2 &&
                                   scene::is_hex_digit(path[at + 1]) && scene::is_hex_digit(path[at + 2]);
        if (const std::size_t refused = looks_encoded ? 1 : refused_bytes(path, at); refused > 0) {
            text += percent_encoded(path.substr(at, refused));
            at += refused;
        } else {
            const std::size_t bytes = scene::utf8_length(path, at);
            text += path.substr(at, bytes);
            at += bytes;
        }
    }
    return text;
}

bool is_media_type(std::string_view text) {
    const auto is_token = [](std::string_view part) {
        return !part.empty() && std::ranges::all_of(part, [](char c) {
            return scene::is_letter(c) || scene::is_digit(c) || c == '-' || c == '+' || c == '.';
        });
    };
    const std::size_t slash = text.find('/');
    return slash != std::string_view::npos && is_token(text.substr(0, slash)) &&
           is_token(text.substr(slash + 1));
}

}  // namespace campuswalk::engine
