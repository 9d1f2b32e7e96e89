#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// Longer lines are refused, bytes: parsed, they take twenty times the memory.
inline constexpr std::size_t kLongestLine = std::size_t{8} << 20U;
/// The error (long-line) about such a line, by its number from 1.
scene::InputError long_line(const std::filesystem::path& file, int number);

/// The lines of a text file one after the other, of which only a block is in memory. The file is open only
/// while a block is read.
class FileLines {
public:
    static constexpr std::size_t kUsualBlock = std::size_t{64} << 10U;

    /// From `offset` bytes on, which is where a line begins.
    explicit FileLines(std::filesystem::path file, std::size_t block_bytes = kUsualBlock,
                       std::uintmax_t offset = 0);

    /// The next line, without its end, until the next call; nullopt at the end of the file. A last line that
    /// was cut short, and has no end, doesn't count. Throws scene::InputError for a file that isn't there,
    /// isn't a regular one or can't be read (missing-file), and for a line that is too long (long-line).
    std::optional<std::string_view> next();

    int number() const { return number_; }  ///< of the last line, from 1
    /// Where the last line begins and the next one does, bytes from the file's beginning.
    std::uintmax_t begin() const { return begin_; }
    std::uintmax_t end() const { return next_block_ - (block_.size() - used_); }

private:
    /// False at the end of the file.
    bool read_block();

    std::filesystem::path file_;
    std::size_t block_bytes_;
    std::string block_;
    std::size_t used_ = 0;           ///< bytes of the block that have been handed out
    std::uintmax_t next_block_ = 0;  ///< where what follows the block is in the file
    std::uintmax_t begin_ = 0;
    int number_ = 0;
};

}  // namespace campuswalk::tools
