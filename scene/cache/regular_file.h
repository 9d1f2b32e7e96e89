#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace campuswalk::scene {

/// An open regular file and its status at that time.
class RegularFile {
public:
    /// nullopt if it isn't one, or can't be opened for reading.
    static std::optional<RegularFile> open(const std::filesystem::path& file);

    ~RegularFile();
    RegularFile(RegularFile&& other) noexcept;
    RegularFile& operator=(RegularFile&&) = delete;

    const struct stat& status() const { return status_; }
    std::size_t size() const { return static_cast<std::size_t>(status_.st_size); }

    /// The number of bytes read, fewer than `to` has only at the file's end; nullopt on errors.
    std::optional<std::size_t> read(std::span<std::byte> to) const;

    /// Whether size and times are those of status() still.
    bool is_unchanged() const;

private:
    RegularFile(int descriptor, const struct stat& status) : descriptor_(descriptor), status_(status) {}

    int descriptor_;
    struct stat status_;
};

}  // namespace campuswalk::scene
