#include "config/loader/text_positions.h"

#include <algorithm>

namespace campuswalk::config {

namespace {

constexpr std::string_view kBlank = " \t\n";
constexpr std::size_t kStride = 256;     // bytes
constexpr std::size_t kFarthest = 4096;  // bytes that are searched for the place of an empty value

bool is_spelled_null(std::string_view rest) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\n,]}"));
    return word == "~" || word == "null" || word == "Null" || word == "NULL";
}

/// The line without a comment and the spaces at its end.
std::string_view without_comment(std::string_view line) {
    std::size_t end = line.size();
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '#' && (i == 0 || kBlank.find(line[i - 1]) != std::string_view::npos)) {
            end = i;
            break;
        }
    }
    line = line.substr(0, end);
    const std::size_t last = line.find_last_not_of(kBlank);
    return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

std::size_t count_characters(std::string_view bytes) {
    return static_cast<std::size_t>(std::ranges::count_if(
        bytes, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

TextPositions::TextPositions(std::string_view text) : text_(text), line_starts_{0} {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            line_starts_.push_back(i + 1);
        }
    }
    std::size_t characters = 0;
    for (std::size_t at = 0; at <= text.size(); at += kStride) {
        characters_.push_back(characters);
        characters += count_characters(text.substr(at, kStride));
    }
}

std::size_t TextPositions::clamped(int offset) const {
    return std::min(offset < 0 ? 0 : static_cast<std::size_t>(offset), text_.size());
}

TextPosition TextPositions::of(int offset) const {
    const std::size_t at = clamped(offset);
    const auto after = std::ranges::upper_bound(line_starts_, at);
    const std::size_t start = *(after - 1);
    const std::size_t characters = characters_before(at) - characters_before(start);
    return {static_cast<int>(after - line_starts_.begin()), static_cast<int>(characters) + 1};
}

std::size_t TextPositions::characters_before(std::size_t at) const {
    const std::size_t stride = at / kStride;
    return characters_[stride] + count_characters(text_.substr(stride * kStride, at - stride * kStride));
}

TextPosition TextPositions::of_null(int offset) const {
    const std::size_t at = clamped(offset);
    if (is_spelled_null(text_.substr(at))) {
        return of(offset);
    }
    std::size_t end = at;
    for (auto line = std::ranges::upper_bound(line_starts_, at); line != line_starts_.begin();) {
        const std::size_t start = *--line;
        if (at - start > kFarthest) {
            break;
        }
        const std::string_view content = without_comment(text_.substr(start, end - start));
        if (!content.empty()) {
            const bool dash = content.back() == '-';
            return dash ? of(static_cast<int>(start + content.size()) - 1) : of(offset);
        }
        end = start;
    }
    return of(offset);
}

}  // namespace campuswalk::config
