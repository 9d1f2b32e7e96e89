#include "engine/events/event_text.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/events/decimals.h"
#include "scene/base/utf8.h"

namespace campuswalk::engine {

namespace {

// Wide enough for the usual contents; a longer text shifts the rest of its line to the right.
constexpr std::size_t kTickWidth = 6;
constexpr std::size_t kTimeWidth = 11;
constexpr std::size_t kKindWidth = 16;
constexpr std::size_t kObjectWidth = 17;

std::string right_aligned(const std::string& text, std::size_t width, char fill) {
    return text.size() < width ? std::string(width - text.size(), fill) + text : text;
}

std::string left_aligned(std::string_view text, std::size_t width) {
    std::string padded(text);
    padded.resize(std::max(width, padded.size()), ' ');
    return padded;
}

/// Whether the characters at `at` must be escaped, and how many bytes they have. Bytes that aren't UTF-8 are
/// kept.
std::pair<bool, std::size_t> next_character(std::string_view text, std::size_t at) {
    const std::size_t bytes = scene::utf8_length(text, at);
    return {bytes > 0 && scene::controls_display(scene::code_point(text.substr(at, bytes))),
            std::max<std::size_t>(1, bytes)};
}

/// Always a single line.
std::string in_quotes(std::string_view text) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string out = "\"";
    for (std::size_t at = 0; at < text.size();) {
        const auto [escaped, bytes] = next_character(text, at);
        const char c = text[at];
        if (c == '"' || c == '\\') {
            out += {'\\', c};
        } else if (c == '\n') {
            out += "\\n";
        } else {
            for (const char each : text.substr(at, bytes)) {
                const auto byte = static_cast<unsigned char>(each);
                out +=
                    escaped ? std::string{'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]} : std::string{each};
            }
        }
        at += bytes;
    }
    return out + '"';
}

std::string text_of(std::int64_t value) {
    return std::to_string(value);
}
std::string text_of(const Decimal& value) {
    return fixed(value.value, value.digits);
}
std::string text_of(const Eigen::Vector3d& value) {
    return fixed(value);
}
std::string text_of(const std::string& value) {
    return text_of_name(value);
}
std::string text_of(const Text& value) {
    return in_quotes(value.value);
}

}  // namespace

std::string text_of_name(const std::string& value) {
    bool breaks_columns = value.empty() || value.find_first_of(" \"\\=") != std::string::npos;
    for (std::size_t at = 0; at < value.size() && !breaks_columns;) {
        const auto [escaped, bytes] = next_character(value, at);
        breaks_columns = escaped;
        at += bytes;
    }
    return breaks_columns ? in_quotes(value) : value;
}

std::string text_line(Tick tick, double time, std::string_view kind, const std::string& object,
                      const std::string& details) {
    return right_aligned(std::to_string(tick), kTickWidth, '0') + ' ' +
           right_aligned(fixed(time, 6), kTimeWidth, ' ') + ' ' + left_aligned(kind, kKindWidth) + ' ' +
           (details.empty() ? object : left_aligned(object, kObjectWidth) + details);
}

std::string text_line(const Event& event, double time) {
    std::string details;
    for (const Field& field : event.fields) {
        details += ' ';
        details += field.name;
        details += '=';
        details += std::visit([](const auto& value) { return text_of(value); }, field.value);
    }
    return text_line(event.tick, time, name_of(event.kind), text_of(event.object), details);
}

}  // namespace campuswalk::engine
