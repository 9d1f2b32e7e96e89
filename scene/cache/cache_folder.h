#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "scene/cache/mapped_file.h"
#include "scene/content_hash.h"

namespace campuswalk::scene {

/// Files under the hash of what they were made from, in one folder that several processes may use at once.
/// They are written beside and renamed, never changed; there is no lock: two that make the same file make it
/// of the same inputs, and the later one replaces it by its equal.
///
/// What is in the folder may be anybody's work: readers check it. A cache that can't be read or written is
/// none; nothing fails because of it.
class CacheFolder {
public:
    static constexpr std::uint64_t kUsualLimit = std::uint64_t{4} << 30U;

    explicit CacheFolder(std::filesystem::path folder, std::uint64_t most_bytes = kUsualLimit)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    /// Such as "model"; letters alone.
    using Kind = std::string;

    /// The file, from now on the one that was used last.
    std::optional<MappedFile> find(const ContentHash& key, const Kind& kind) const;

    /// Keeps the bytes, then removes the files that were used longest ago until all fit the limit. What is
    /// larger than that by itself isn't kept. The reason if it can't be written, else empty.
    std::string store(const ContentHash& key, const Kind& kind, std::span<const std::byte> bytes) const;

private:
    std::filesystem::path path_of(const ContentHash& key, const Kind& kind) const;
    void make_room() const;

    std::filesystem::path folder_;
    std::uint64_t most_bytes_;
};

}  // namespace campuswalk::scene
