#include "engine/events/event_text.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "scene/base/printable.h"

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

/// Always a single line.
std::string in_quotes(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return '"' + scene::printable(out) + '"';
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
std::string text_of_field(const auto& value) {
    return text_of(value);
}
std::string text_of_field(const std::shared_ptr<const Reason>& value) {
    return in_quotes(text_of(*value));
}

}  // namespace

std::string text_of_name(const std::string& value) {
    const bool breaks_columns = value.empty() || value.find_first_of(" \"\\=") != std::string::npos ||
                                scene::printable(value) != value;
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
        details += std::visit([](const auto& value) { return text_of_field(value); }, field.value);
    }
    return text_line(event.tick, time, name_of(event.kind), text_of(event.object), details);
}

}  // namespace campuswalk::engine
