#include "scene/cache/cache_claim.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <limits>
#include <utility>

namespace campuswalk::scene {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kFirstPause = 1ms;
constexpr std::chrono::nanoseconds kLongestPause = 100ms;

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

/// False if a signal came.
bool sleep_through(std::chrono::nanoseconds pause) {
    const timespec time{0, static_cast<long>(pause.count())};  // less than a second
    return nanosleep(&time, nullptr) == 0;
}

}  // namespace

// Locks of open file descriptions (F_OFD_…) hold between threads, too, and end when the file is closed.

std::optional<CacheClaim> CacheClaim::wait_or_take(const std::filesystem::path& file, const ContentHash& key,
                                                   std::chrono::nanoseconds longest) {
    CacheClaim claim(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR));
    if (claim.descriptor_ < 0) {
        return claim;
    }
    // Whoever has it may be stopped, by a debugger or a scheduler: nobody waits for ever.
    const auto end = std::chrono::steady_clock::now() + longest;
    std::chrono::nanoseconds pause = kFirstPause;
    while (true) {
        struct flock own = lock_of(F_WRLCK, key);
        if (fcntl(claim.descriptor_, F_OFD_SETLK, &own) == 0) {
            break;
        }
        const bool is_taken = errno == EAGAIN || errno == EACCES;
        if (!is_taken || std::chrono::steady_clock::now() >= end || !sleep_through(pause)) {
            return claim;
        }
        pause = std::min(2 * pause, kLongestPause);
    }
    // Whoever waited lets go at once, so that all who wait go on.
    return pause == kFirstPause ? std::optional(std::move(claim)) : std::nullopt;
}

CacheClaim::~CacheClaim() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

CacheClaim::CacheClaim(CacheClaim&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace campuswalk::scene
