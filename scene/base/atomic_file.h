#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace campuswalk::scene {

/// Replaces a file atomically, creating its parent folders: a temporary file with a unique name in the same
/// folder is renamed over it. Readers see the old contents or the new; several processes may write the same
/// file at a time. Throws std::runtime_error with the file name and the system's reason, also if the path
/// names something other than a regular file, such as a device.
void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& file, std::string_view text);
void write_file_atomically(const std::filesystem::path& file,
                           std::span<const std::span<const std::byte>> buffers);

/// The same for a file that is written piece by piece. The temporary file is removed unless finish()
/// succeeds. Every member throws as above.
class AtomicFile {
public:
    /// Creates the temporary file.
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    /// Overwrites bytes written before.
    void replace(std::size_t offset, std::span<const std::byte> bytes);
    /// Renames the temporary file. Nothing may be written afterwards.
    void finish();

private:
    struct Close {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };
    std::filesystem::path file_;
    std::filesystem::path temporary_;
    std::unique_ptr<std::FILE, Close> stream_;
};

/// The suffix of temporary files, which a killed process leaves behind.
inline constexpr std::string_view kTemporarySuffix = ".part";

}  // namespace campuswalk::scene
