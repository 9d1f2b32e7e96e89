#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "scene/cache/cache_claim.h"
#include "scene/cache/content_hash.h"
#include "scene/cache/file_contents.h"

namespace campuswalk::scene {

/// A content-addressed cache: files named by the hash of their inputs, in a folder that several processes may
/// use at once. Files are written atomically and never changed, so they need no lock: two processes that
/// write the same file write the same contents. What takes long can be claimed, so that only one makes it.
///
/// The contents are untrusted: callers validate them. Read and write errors never fail the caller: they count
/// as cache misses. So does everything in a folder that another user owns or may write to: files there could
/// be valid and yet of another model.
class CacheFolder {
public:
    static constexpr std::uint64_t kDefaultLimit = std::uint64_t{4} << 30U;

    /// `on_write_error` is called with the reason whenever a file can't be stored.
    explicit CacheFolder(std::filesystem::path folder, std::uint64_t max_bytes = kDefaultLimit,
                         std::function<void(const std::string&)> on_write_error = {})
        : folder_(std::move(folder)), max_bytes_(max_bytes), on_write_error_(std::move(on_write_error)) {}

    /// Such as "model"; letters only.
    using Kind = std::string;

    /// The file, which becomes the most recently used; null if there is none, or if another user may have
    /// written it.
    std::shared_ptr<const FileContents> find(const ContentHash& key, const Kind& kind) const;

    /// Stores the bytes, then removes the least recently used files until the rest fits the limit. A file
    /// larger than the limit is not stored.
    void store(const ContentHash& key, const Kind& kind,
               std::span<const std::span<const std::byte>> buffers) const;

    /// The claim to make the file; see CacheClaim::wait_or_take. In a folder that can't be used everybody
    /// gets it.
    std::optional<CacheClaim> claim(const ContentHash& key) const;

private:
    void make_folder() const;
    std::filesystem::path path_of(const ContentHash& key, const Kind& kind) const;
    void report(const std::string& error) const;
    void evict() const;

    std::filesystem::path folder_;
    std::uint64_t max_bytes_;
    std::function<void(const std::string&)> on_write_error_;
};

}  // namespace campuswalk::scene
