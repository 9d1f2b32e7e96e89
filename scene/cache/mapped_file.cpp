#include "scene/cache/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <utility>

namespace campuswalk::scene {

std::optional<MappedFile> MappedFile::open(const std::filesystem::path& file) {
    // Not to wait for what may never come: a pipe is no regular file, but opening it would block.
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        return std::nullopt;
    }
    std::optional<MappedFile> mapped;
    struct stat status {};
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
        const auto size = static_cast<std::size_t>(status.st_size);
        if (size == 0) {
            mapped = MappedFile(nullptr, 0);
        } else if (void* start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
                   start != MAP_FAILED) {
            mapped = MappedFile(start, size);
        }
    }
    ::close(descriptor);
    return mapped;
}

void MappedFile::drop(std::span<const std::byte> part) const {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto start = reinterpret_cast<std::uintptr_t>(part.data());
    const std::uintptr_t first = (start + page - 1) / page * page;
    const std::uintptr_t end = (start + part.size()) / page * page;
    if (first < end) {
        madvise(static_cast<std::byte*>(start_) + (first - reinterpret_cast<std::uintptr_t>(start_)),
                end - first, MADV_DONTNEED);
    }
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
