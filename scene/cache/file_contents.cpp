#include "scene/cache/file_contents.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "collision/base/large_pages.h"
#include "scene/cache/regular_file.h"

namespace campuswalk::scene {

namespace {

bool only_we_can_write(const struct stat& status) {
    return status.st_uid == geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

}  // namespace

std::optional<FileContents> FileContents::read_own(const std::filesystem::path& path) {
    const std::optional<RegularFile> file = RegularFile::open(path);
    if (!file || !only_we_can_write(file->status())) {
        return std::nullopt;
    }
    const std::size_t size = file->size();
    if (size == 0) {
        return FileContents(nullptr, 0);
    }
    void* start = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (start == MAP_FAILED) {
        return std::nullopt;
    }
    FileContents contents(start, size);
    collision::prefer_large_pages(start, size);
    const bool complete = file->read({static_cast<std::byte*>(start), size}) == size;
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

bool is_own_folder(const std::filesystem::path& folder) {
    struct stat status {};
    return stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && only_we_can_write(status);
}

}  // namespace campuswalk::scene
