#include "scene/cache/file_contents.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "collision/base/large_pages.h"

namespace campuswalk::scene {

namespace {

bool only_we_can_write(const struct stat& status) {
    return status.st_uid == geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

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
    bool is_own() const { return only_we_can_write(status_); }
    std::size_t size() const { return static_cast<std::size_t>(status_.st_size); }

    /// The number of bytes read, fewer than `to` has only at the file's end; nullopt on errors.
    std::optional<std::size_t> read(std::span<std::byte> to) const {
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

private:
    int descriptor_;
    struct stat status_ {};
    bool is_open_ = false;
};

}  // namespace

std::optional<FileContents> FileContents::read_own(const std::filesystem::path& path) {
    const RegularFile file(path);
    if (!file.is_open() || !file.is_own()) {
        return std::nullopt;
    }
    const std::size_t size = file.size();
    if (size == 0) {
        return FileContents(nullptr, 0);
    }
    void* start = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (start == MAP_FAILED) {
        return std::nullopt;
    }
    FileContents contents(start, size);
    collision::prefer_large_pages(start, size);
    const bool complete = file.read({static_cast<std::byte*>(start), size}) == size;
    return complete ? std::optional(std::move(contents)) : std::nullopt;
}

FileContents::~FileContents() {
    if (start_ != nullptr) {
        munmap(start_, size_);
    }
}

FileContents::FileContents(FileContents&& other) noexcept
    : start_(std::exchange(other.start_, nullptr)), size_(std::exchange(other.size_, 0)) {}

FileContents& FileContents::operator=(FileContents&& other) noexcept {
    std::swap(start_, other.start_);
    std::swap(size_, other.size_);
    return *this;
}

std::optional<ContentHash> hash_of_file(const std::filesystem::path& path) {
    const RegularFile file(path);
    if (!file.is_open()) {
        return std::nullopt;
    }
    ContentHasher hasher;
    std::vector<std::byte> part(std::size_t{1} << 18U);
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

bool is_own_folder(const std::filesystem::path& folder) {
    struct stat status {};
    return stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && only_we_can_write(status);
}

}  // namespace campuswalk::scene
