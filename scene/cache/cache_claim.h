#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "scene/cache/content_hash.h"

namespace campuswalk::scene {

/// The right to make what belongs to a key, which one at a time has of all processes and threads that use a
/// cache. It ends with this object, or with its process, however that ends.
///
/// It saves work and decides nothing: where the file system has no locks, everybody gets it.
class CacheClaim {
public:
    /// Of nothing that anybody else could claim.
    CacheClaim() = default;
    /// `file` is for nothing but claims, and is made if need be; its folder must be nobody else's. While
    /// somebody else has the claim, waits until it ends, and returns nullopt: what belongs to the key may be
    /// there now. Waits no longer than `longest`, nor if a signal comes: then the claim is given to both.
    static std::optional<CacheClaim> wait_or_take(const std::filesystem::path& file, const ContentHash& key,
                                                  std::chrono::nanoseconds longest = std::chrono::minutes(1));

    ~CacheClaim();
    CacheClaim(CacheClaim&& other) noexcept;
    CacheClaim& operator=(CacheClaim&&) = delete;

private:
    explicit CacheClaim(int descriptor) : descriptor_(descriptor) {}

    int descriptor_ = -1;
};

}  // namespace campuswalk::scene
