#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace campuswalk::scene {

/// A file mapped into memory. If it is truncated meanwhile, access raises SIGBUS.
class MappedFile {
public:
    /// Not copied. nullopt if it can't be opened or is not a regular file (or a symbolic link to one).
    static std::optional<MappedFile> open(const std::filesystem::path& file);

    /// For bytes that must not change. Copies the file if other users may write to it; our own processes
    /// replace files and never change them.
    static std::optional<MappedFile> open_unchanging(const std::filesystem::path& file);

    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;

    std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(start_), size_}; }

private:
    template <typename Start>
    static std::optional<MappedFile> open(const std::filesystem::path& path, const Start& start);
    MappedFile(void* start, std::size_t size) : start_(start), size_(size) {}

    void* start_ = nullptr;  ///< null for an empty file
    std::size_t size_ = 0;
};

}  // namespace campuswalk::scene
