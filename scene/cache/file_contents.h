#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace campuswalk::scene {

/// The bytes of a regular file, copied: unlike a mapping they don't change, and can't raise SIGBUS, when
/// somebody rewrites or truncates the file. Processes that are forked later share the copy.
class FileContents {
public:
    /// nullopt if it isn't a regular file of this user that nobody else may write to, or can't be read.
    static std::optional<FileContents> read_own(const std::filesystem::path& file);

    ~FileContents();
    FileContents(FileContents&& other) noexcept;
    FileContents& operator=(FileContents&& other) noexcept;

    std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(start_), size_}; }

private:
    FileContents(void* start, std::size_t size) : start_(start), size_(size) {}

    void* start_ = nullptr;  ///< null for an empty file
    std::size_t size_ = 0;
};

/// Whether the folder belongs to this user and nobody else may write to it.
bool is_own_folder(const std::filesystem::path& folder);

}  // namespace campuswalk::scene
