#include "scene/cache/regular_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace campuswalk::scene {

namespace {

bool same_time(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

}  // namespace

std::optional<RegularFile> RegularFile::open(const std::filesystem::path& file) {
    // Opening a pipe would block without O_NONBLOCK.
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        return std::nullopt;
    }
    struct stat status {};
    const bool is_known = fstat(descriptor, &status) == 0;
    RegularFile opened(descriptor, status);
    return is_known && S_ISREG(status.st_mode) ? std::optional(std::move(opened)) : std::nullopt;
}

RegularFile::~RegularFile() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), status_(other.status_) {}

std::optional<std::size_t> RegularFile::read(std::span<std::byte> to) const {
    std::size_t done = 0;
    while (done < to.size()) {
        const ssize_t got = ::read(descriptor_, to.data() + done, to.size() - done);
        if (got == 0) {
            break;
        }
        if (got < 0 && errno != EINTR) {
            return std::nullopt;
        }
        done += got > 0 ? static_cast<std::size_t>(got) : 0;
    }
    return done;
}

bool RegularFile::is_unchanged() const {
    struct stat now {};
    return fstat(descriptor_, &now) == 0 && now.st_size == status_.st_size &&
           same_time(now.st_mtim, status_.st_mtim) && same_time(now.st_ctim, status_.st_ctim);
}

}  // namespace campuswalk::scene
