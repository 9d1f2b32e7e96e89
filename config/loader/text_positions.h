#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace campuswalk::config {

/// Line and column in a text, both from 1; the column counts characters, not bytes.
struct TextPosition {
    int line = 0;
    int column = 0;
};

/// Of UTF-8.
std::size_t count_characters(std::string_view bytes);

/// Turns byte offsets into lines and columns. The text must outlive it.
class TextPositions {
public:
    explicit TextPositions(std::string_view text);

    /// An offset behind the end is taken for the end.
    TextPosition of(int offset) const;

    /// Where an empty value stands: the YAML parser reports what comes after it, maybe lines below.
    /// A value spelled `~` or `null` stands where it stands; otherwise it is the `-` before the gap, if any.
    TextPosition of_null(int offset) const;

private:
    std::size_t clamped(int offset) const;
    /// Characters before a byte offset.
    std::size_t characters_before(std::size_t at) const;

    std::string_view text_;
    std::vector<std::size_t> line_starts_;
    std::vector<std::size_t> characters_;  ///< before every kStride-th byte: a file may be a single line
};

}  // namespace campuswalk::config
