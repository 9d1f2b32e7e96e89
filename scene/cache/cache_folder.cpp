#include "scene/cache/cache_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <vector>

#include "scene/base/atomic_file.h"

namespace campuswalk::scene {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSuffix = ".campuswalk";
constexpr std::size_t kHashDigits = 64;
constexpr std::string_view kClaims = "claims.campuswalk";

struct Entry {
    timespec used{};
    fs::path path;
    std::uint64_t bytes = 0;

    bool operator<(const Entry& other) const {
        return std::tie(used.tv_sec, used.tv_nsec, path) <
               std::tie(other.used.tv_sec, other.used.tv_nsec, other.path);
    }
};

/// Whether the file name is one of the cache: a folder chosen by the user may hold other files.
bool is_ours(const std::string& name) {
    const bool hashed =
        name.size() > kHashDigits && name.find_first_not_of("0123456789abcdef") == kHashDigits;
    return hashed && name.find(kSuffix) != std::string::npos &&
           (name.ends_with(kSuffix) || name.ends_with(kTemporarySuffix));
}

/// The files of the cache, least recently used first.
std::vector<Entry> entries_in(const fs::path& folder) {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        struct stat status {};
        if (is_ours(it->path().filename().string()) && lstat(it->path().c_str(), &status) == 0 &&
            S_ISREG(status.st_mode)) {
            entries.push_back({status.st_mtim, it->path(), static_cast<std::uint64_t>(status.st_size)});
        }
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

}  // namespace

fs::path CacheFolder::path_of(const ContentHash& key, const Kind& kind) const {
    return folder_ / (to_string(key) + "." + kind + std::string(kSuffix));
}

std::shared_ptr<const FileContents> CacheFolder::find(const ContentHash& key, const Kind& kind) const {
    const fs::path file = path_of(key, kind);
    std::optional<FileContents> found = is_own_folder(folder_) ? FileContents::read_own(file) : std::nullopt;
    if (!found) {
        return nullptr;
    }
    // Not every file system records access times.
    utimensat(AT_FDCWD, file.c_str(), nullptr, 0);
    return std::make_shared<const FileContents>(std::move(*found));
}

void CacheFolder::store(const ContentHash& key, const Kind& kind,
                        std::span<const std::span<const std::byte>> buffers) const {
    std::uint64_t bytes = 0;
    for (const std::span<const std::byte> buffer : buffers) {
        bytes += buffer.size();
    }
    if (bytes > max_bytes_) {
        return;
    }
    make_folder();
    std::error_code error;
    if (fs::is_directory(folder_, error) && !is_own_folder(folder_)) {
        report("'" + folder_.string() + "' isn't used: another user owns it or may write to it (chmod go-w)");
        return;
    }
    const fs::path file = path_of(key, kind);
    try {
        write_file_atomically(file, buffers);
        // Whatever the umask is: files that others may write to aren't read.
        fs::permissions(file, fs::perms::group_write | fs::perms::others_write, fs::perm_options::remove,
                        error);
    } catch (const std::runtime_error& failure) {
        report(failure.what());
    }
    evict();
}

std::optional<CacheClaim> CacheFolder::claim(const ContentHash& key) const {
    make_folder();
    return is_own_folder(folder_) ? CacheClaim::wait_or_take(folder_ / kClaims, key) : CacheClaim();
}

void CacheFolder::make_folder() const {
    std::error_code error;
    if (fs::create_directories(folder_, error)) {
        fs::permissions(folder_, fs::perms::owner_all, error);  // models may be confidential
    }
}

void CacheFolder::report(const std::string& error) const {
    if (on_write_error_) {
        on_write_error_(error);
    }
}

void CacheFolder::evict() const {
    const std::vector<Entry> entries = entries_in(folder_);
    std::uint64_t bytes = 0;
    for (const Entry& entry : entries) {
        bytes += entry.bytes;
    }
    for (auto entry = entries.begin(); entry != entries.end() && bytes > max_bytes_; ++entry) {
        std::error_code ignored;  // another process may have removed it
        fs::remove(entry->path, ignored);
        bytes -= entry->bytes;
    }
}

}  // namespace campuswalk::scene
