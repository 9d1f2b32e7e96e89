#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "scene/base/content_hash.h"
#include "scene/cache/mapped_file.h"

namespace campuswalk::scene {

/// Files under the hash of what they were made from, in one folder that several processes may use at once.
/// They are written beside and renamed, never changed; there is no lock: two that make the same file make it
/// of the same inputs, and the later one replaces it by its equal.
///
/// What is in the folder may be anybody's work: readers check it. A cache that can't be read or written is
/// none; nothing fails because of it.
class CacheFolder {
public:
    static constexpr std::uint64_t kDefaultLimit = std::uint64_t{4} << 30U;

    /// `unwritable`: told why, each time that something can't be kept.
    explicit CacheFolder(std::filesystem::path folder, std::uint64_t max_bytes = kDefaultLimit,
                         std::function<void(const std::string&)> unwritable = {})
        : folder_(std::move(folder)), max_bytes_(max_bytes), on_write_error_(std::move(unwritable)) {}

    /// Such as "model"; letters alone.
    using Kind = std::string;

    /// The file, from now on the one that was used last; null if there is none. As long as it lives its bytes
    /// stay what they are.
    std::shared_ptr<const MappedFile> find(const ContentHash& key, const Kind& kind) const;

    /// Keeps the bytes, then removes the files that were used longest ago until all fit the limit. What is
    /// larger than that by itself isn't kept.
    void store(const ContentHash& key, const Kind& kind,
               std::span<const std::span<const std::byte>> parts) const;

private:
    std::filesystem::path path_of(const ContentHash& key, const Kind& kind) const;
    void make_room() const;

    std::filesystem::path folder_;
    std::uint64_t max_bytes_;
    std::function<void(const std::string&)> on_write_error_;
};

}  // namespace campuswalk::scene
