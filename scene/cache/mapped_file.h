#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace campuswalk::scene {

/// A whole file as memory, read ahead, no copy made. Nobody may cut it short meanwhile: what is gone then
/// ends the process when it is looked at. Our own files are never changed, only replaced.
class MappedFile {
public:
    /// nullopt if it can't be opened or is no regular file (what a symbolic link names is followed).
    static std::optional<MappedFile> open(const std::filesystem::path& file);

    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;

    std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(start_), size_}; }

    /// Takes a part of `bytes()` out of memory; the next look at it would read it from the file again.
    void drop(std::span<const std::byte> part) const;

private:
    MappedFile(void* start, std::size_t size) : start_(start), size_(size) {}

    void* start_ = nullptr;  ///< null for an empty file
    std::size_t size_ = 0;
};

}  // namespace campuswalk::scene
