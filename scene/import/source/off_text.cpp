#include "scene/import/source/off_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace campuswalk::scene {
namespace {

constexpr std::string_view kBlank = " \t\r";

/// Lines with something on them, without comments.
class OffLines {
public:
    explicit OffLines(std::string_view text) : text_(text) {}

    /// nullopt at the end.
    std::optional<std::string_view> next() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            std::string_view line = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            line = line.substr(0, line.find('#'));
            line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
            if (!line.empty()) {
                return line;
            }
        }
        return std::nullopt;
    }

private:
    std::string_view text_;
};

/// Takes a number off the front.
std::optional<std::size_t> take_count(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
    if (error != std::errc()) {
        return std::nullopt;
    }
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return count;
}

}  // namespace

std::string fault_of_off(std::span<const std::uint8_t> off) {
    constexpr std::size_t kMostVertices = 9;
    OffLines lines({reinterpret_cast<const char*>(off.data()), off.size()});
    std::string_view line = lines.next().value_or("");
    if (line.find("OFF") != std::string_view::npos) {  // the counts may follow on the same line
        line = line.substr(std::min(line.find_first_of(kBlank), line.size()));
        line = line.find_first_of("0123456789") == std::string_view::npos ? lines.next().value_or("") : line;
    }
    const std::size_t vertices = take_count(line).value_or(0);
    const std::size_t faces = take_count(line).value_or(0);
    for (std::size_t i = 0; i < vertices && lines.next(); ++i) {
    }
    for (std::size_t i = 0; i < faces; ++i) {
        std::optional<std::string_view> face = lines.next();
        if (!face) {
            break;  // assimp says what is missing
        }
        if (const auto count = take_count(*face); count && *count > kMostVertices) {
            return "its face " + std::to_string(i + 1) + " has " + std::to_string(*count) +
                   " vertices, and faces of OFF files are read up to " + std::to_string(kMostVertices) +
                   "; triangulate it, or convert it to OBJ or PLY";
        }
    }
    return "";
}

}  // namespace campuswalk::scene
