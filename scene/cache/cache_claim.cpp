#include "scene/cache/cache_claim.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <utility>

namespace campuswalk::scene {

namespace {

/// One byte of the file stands for the key, whether the file is that long or not: so there is no lock file
/// for each key that somebody would have to remove. Keys that share one wait for each other without need.
struct flock lock_of(short type, const ContentHash& key) {
    constexpr int kBytes = 7;
    off_t place = 0;
    static_assert(std::numeric_limits<off_t>::digits > 8 * kBytes);
    for (int i = 0; i < kBytes; ++i) {
        place = place * 256 + key.bytes[static_cast<std::size_t>(i)];
    }
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = place;
    lock.l_len = 1;
    return lock;
}

}  // namespace

// Locks of open file descriptions (F_OFD_…) hold between threads, too, and end when the file is closed.

std::optional<CacheClaim> CacheClaim::wait_or_take(const std::filesystem::path& file,
                                                   const ContentHash& key) {
    CacheClaim claim(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR));
    if (claim.descriptor_ < 0) {
        return claim;
    }
    struct flock own = lock_of(F_WRLCK, key);
    if (fcntl(claim.descriptor_, F_OFD_SETLK, &own) == 0 || (errno != EAGAIN && errno != EACCES)) {
        return claim;
    }
    // All who wait go on at once.
    struct flock shared = lock_of(F_RDLCK, key);
    while (fcntl(claim.descriptor_, F_OFD_SETLKW, &shared) != 0) {
        if (errno != EINTR) {
            return claim;
        }
    }
    return std::nullopt;
}

CacheClaim::~CacheClaim() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

CacheClaim::CacheClaim(CacheClaim&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace campuswalk::scene
