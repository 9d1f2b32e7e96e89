#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "scene/base/new_file.h"

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
/// succeeds; a process that is killed leaves it behind. So the first file that a process writes in a folder
/// removes what others have left there: temporary files, by their names, that nobody holds a lock (flock) on.
/// Where the file system has no locks, none are removed; on one that keeps locks to a machine, others' that
/// are being written would be. Every member throws as above.
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

    /// The temporary file, for a program that writes it in place of write().
    const std::filesystem::path& temporary() const { return temporary_; }

private:
    std::filesystem::path file_;
    std::filesystem::path temporary_;
    FileStream stream_;
    FileStream
        lock_;  ///< the stream's descriptor once more: it outlives the stream until the file has its name
};

/// The suffix of temporary files, which a killed process leaves behind: NAME.campuswalk-PROCESS-NUMBER.part.
/// Nobody else's file is called so.
inline constexpr std::string_view kTemporarySuffix = ".part";
inline constexpr std::string_view kTemporaryMark = ".campuswalk-";

/// Whether a file's name is that of a temporary file.
bool is_temporary(std::string_view name);

}  // namespace campuswalk::scene
