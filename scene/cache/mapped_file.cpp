#include "scene/cache/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "collision/base/large_pages.h"

namespace campuswalk::scene {

namespace {

/// An open file and its status at that time.
class RegularFile {
public:
    explicit RegularFile(const std::filesystem::path& file)
        // Opening a pipe would block without O_NONBLOCK.
        : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        is_open_ = descriptor_ >= 0 && fstat(descriptor_, &status_) == 0 && S_ISREG(status_.st_mode);
    }
    ~RegularFile() {
        if (descriptor_ >= 0) {
            close(descriptor_);
        }
    }
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    bool is_open() const { return is_open_; }
    std::size_t size() const { return static_cast<std::size_t>(status_.st_size); }
    bool only_we_can_write() const {
        return status_.st_uid == geteuid() && (status_.st_mode & (S_IWGRP | S_IWOTH)) == 0;
    }

    /// MAP_FAILED on failure.
    void* map() const { return mmap(nullptr, size(), PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor_, 0); }
    /// MAP_FAILED on failure, also if the file is shorter by now.
    void* copy() const {
        void* start = mmap(nullptr, size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (start != MAP_FAILED) {
            collision::prefer_large_pages(start, size());
            if (!read_into(static_cast<std::byte*>(start))) {
                munmap(start, size());
                start = MAP_FAILED;
            }
        }
        return start;
    }

private:
    bool read_into(std::byte* to) const {
        std::size_t done = 0;
        while (done < size()) {
            const ssize_t got = read(descriptor_, to + done, size() - done);
            if (got == 0 || (got < 0 && errno != EINTR)) {
                return false;
            }
            done += got > 0 ? static_cast<std::size_t>(got) : 0;
        }
        return true;
    }

    int descriptor_;
    struct stat status_ {};
    bool is_open_ = false;
};

}  // namespace

template <typename Start>
std::optional<MappedFile> MappedFile::open(const std::filesystem::path& path, const Start& start) {
    const RegularFile file(path);
    if (!file.is_open()) {
        return std::nullopt;
    }
    void* at = file.size() > 0 ? start(file) : nullptr;
    return at != MAP_FAILED ? std::optional(MappedFile(at, file.size())) : std::nullopt;
}

std::optional<MappedFile> MappedFile::open(const std::filesystem::path& path) {
    return open(path, [](const auto& file) { return file.map(); });
}

std::optional<MappedFile> MappedFile::open_unchanging(const std::filesystem::path& path) {
    return open(path, [](const auto& file) { return file.only_we_can_write() ? file.map() : file.copy(); });
}

MappedFile::~MappedFile() {
    if (start_ != nullptr) {
        munmap(start_, size_);
    }
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : start_(std::exchange(other.start_, nullptr)), size_(std::exchange(other.size_, 0)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(start_, other.start_);
    std::swap(size_, other.size_);
    return *this;
}

}  // namespace campuswalk::scene
