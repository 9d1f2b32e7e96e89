#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace campuswalk::scene {

/// Writes a file whole or not at all, with the folders it needs: a neighbour of a name of its own is renamed
/// over it, so that several processes may write the same file at a time, and who reads it meanwhile reads the
/// old one or the new. Throws std::runtime_error with the file and the system's reason; what is there but is
/// no regular file, such as a device, is left alone.
void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& file, std::string_view text);
/// Of bytes that lie in several places.
void write_file_atomically(const std::filesystem::path& file,
                           std::span<const std::span<const std::byte>> parts);

/// Likewise a file whose bytes come one after the other: they go into the neighbour, which is gone again
/// unless all ends well. Everything throws as above.
class AtomicFile {
public:
    /// Makes the neighbour.
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    /// In the place of others that were written there.
    void replace(std::size_t offset, std::span<const std::byte> bytes);
    /// Renames it. Nothing can be written after that.
    void finish();

private:
    struct Close {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };
    std::filesystem::path file_;
    std::filesystem::path part_;
    std::unique_ptr<std::FILE, Close> stream_;
};

/// How the neighbours' names end, should a process be killed and leave one behind.
inline constexpr std::string_view kTemporarySuffix = ".part";

}  // namespace campuswalk::scene
