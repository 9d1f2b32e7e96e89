#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace campuswalk::scene {

/// A whole file as memory. Nobody may cut it short meanwhile: what is gone then ends the process when it is
/// looked at.
class MappedFile {
public:
    /// Read ahead, no copy made. nullopt if it can't be opened or is no regular file (what a symbolic link
    /// names is followed).
    static std::optional<MappedFile> open(const std::filesystem::path& file);

    /// For files whose bytes must stay what they are. One that others could change is copied; one that is
    /// ours, and that nobody else may write to, isn't: we replace our files and never change them.
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
