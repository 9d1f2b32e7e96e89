#include "scene/cache/file_hash.h"

#include <algorithm>
#include <ctime>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/cache/regular_file.h"

namespace campuswalk::scene {

namespace {

constexpr const char* kStampKind = "stamp";
constexpr FileKind kStampFile = {{'c', 'w', ' ', 's', 't', 'a', 'm', 'p'}, 1};

constexpr std::size_t kStampedFrom = std::size_t{1} << 20U;  // bytes; smaller files are hashed in 1 ms
constexpr std::time_t kSettled = 2;                          // seconds: the coarsest file systems' times

void add_time(ContentHasher& hasher, const timespec& time) {
    hasher.add_number(static_cast<std::uint64_t>(time.tv_sec));
    hasher.add_number(static_cast<std::uint64_t>(time.tv_nsec));
}

ContentHash stamp_of(const struct stat& status) {
    ContentHasher hasher;
    hasher.add_text(kStampKind);
    hasher.add_number(static_cast<std::uint64_t>(status.st_dev));
    hasher.add_number(static_cast<std::uint64_t>(status.st_ino));
    hasher.add_number(static_cast<std::uint64_t>(status.st_size));
    add_time(hasher, status.st_mtim);
    add_time(hasher, status.st_ctim);
    return hasher.result();
}

bool is_settled(const struct stat& status) {
    return std::max(status.st_mtim.tv_sec, status.st_ctim.tv_sec) + kSettled < std::time(nullptr);
}

std::optional<ContentHash> remembered(const ContentHash& stamp, const CacheFolder& cache) {
    const auto file = cache.find(stamp, kStampKind);
    if (!file) {
        return std::nullopt;
    }
    try {
        ArchiveReader in(file->bytes(), kStampFile);
        ContentHash hash;
        std::ranges::copy(in.take_all<std::uint8_t>(hash.bytes.size()), hash.bytes.begin());
        in.finish();
        return hash;
    } catch (const DamagedFile&) {
        return std::nullopt;
    }
}

void remember(const ContentHash& hash, const ContentHash& stamp, const CacheFolder& cache) {
    ArchiveWriter out(kStampFile);
    out.put_all(std::span<const std::uint8_t>(hash.bytes));
    cache.store(stamp, kStampKind, out.finish());
}

std::optional<ContentHash> hash_of_contents(const RegularFile& file) {
    ContentHasher hasher;
    std::vector<std::byte> part(std::min(file.size() + 1, std::size_t{1} << 18U));
    for (;;) {
        const std::optional<std::size_t> size = file.read(part);
        if (!size) {
            return std::nullopt;
        }
        hasher.add(std::span(part).first(*size));
        if (*size < part.size()) {
            return hasher.result();
        }
    }
}

}  // namespace

std::optional<ContentHash> hash_of_file(const std::filesystem::path& path, const CacheFolder* cache) {
    const std::optional<RegularFile> file = RegularFile::open(path);
    if (!file) {
        return std::nullopt;
    }
    if (cache == nullptr || file->size() < kStampedFrom || !is_settled(file->status())) {
        return hash_of_contents(*file);
    }
    const ContentHash stamp = stamp_of(file->status());
    if (const std::optional<ContentHash> hash = remembered(stamp, *cache)) {
        return hash;
    }
    const std::optional<ContentHash> hash = hash_of_contents(*file);
    if (hash && file->is_unchanged()) {
        remember(*hash, stamp, *cache);
    }
    return hash;
}

const ContentHash& program_hash(const CacheFolder* cache) {
    static const ContentHash hash = hash_of_file("/proc/self/exe", cache).value_or(ContentHash{});
    return hash;
}

}  // namespace campuswalk::scene
