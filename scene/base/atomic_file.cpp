#include "scene/base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace campuswalk::scene {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw std::runtime_error("can't write '" + file.string() + "': " + reason);
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

bool is_locked(int descriptor) {
    return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

/// Whether the file still has its name.
bool is_at(int descriptor, const fs::path& path) {
    struct stat opened {};
    struct stat named {};
    return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Tries several names: process ids are not unique if containers share a folder.
FileStream create_temporary(const fs::path& file, fs::path& temporary) {
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        temporary = file;
        temporary += std::string(kTemporaryMark) + std::to_string(getpid()) + "-" + std::to_string(i) +
                     std::string(kTemporarySuffix);
        FileStream stream(std::fopen(temporary.c_str(), "wbxe"));
        if (!stream && errno != EEXIST) {
            return nullptr;
        }
        // Without locks nobody removes it. With them, somebody may have between the two calls.
        if (stream && (is_locked(fileno(stream.get())) || errno != EWOULDBLOCK) &&
            is_at(fileno(stream.get()), temporary)) {
            return stream;
        }
    }
    errno = EEXIST;
    return nullptr;
}

void remove_if_abandoned(const fs::path& temporary) {
    const int descriptor = open(temporary.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) {
        return;
    }
    struct stat status {};
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && is_locked(descriptor) &&
        is_at(descriptor, temporary)) {
        unlink(temporary.c_str());
    }
    close(descriptor);
}

/// Once a process: folders may have thousands of files, each of them written like this.
void remove_abandoned_once(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> done;
    std::error_code error;
    const std::lock_guard lock(mutex);
    if (!done.insert(fs::weakly_canonical(folder.empty() ? "." : folder, error)).second) {
        return;
    }
    for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end;
         it.increment(error)) {
        if (is_temporary(it->path().filename().string())) {
            remove_if_abandoned(it->path());
        }
    }
}

}  // namespace

bool is_temporary(std::string_view name) {
    const std::size_t mark = name.rfind(kTemporaryMark);
    if (mark == std::string_view::npos || mark == 0 || !name.ends_with(kTemporarySuffix)) {
        return false;
    }
    name.remove_prefix(mark + kTemporaryMark.size());
    name.remove_suffix(kTemporarySuffix.size());
    const std::size_t dash = name.find_first_not_of("0123456789");
    return dash != 0 && dash != std::string_view::npos && name[dash] == '-' && dash + 1 < name.size() &&
           name.find_first_not_of("0123456789", dash + 1) == std::string_view::npos;
}

AtomicFile::AtomicFile(fs::path file) : file_(std::move(file)) {
    std::error_code error;
    if (fs::exists(file_, error) && !fs::is_regular_file(file_, error)) {
        fail(file_, "it is not a regular file");  // the rename would replace a device
    }
    remove_abandoned_once(file_.parent_path());
    stream_ = create_temporary(file_, temporary_);
    if (!stream_ && errno == ENOENT && file_.has_parent_path()) {
        fs::create_directories(file_.parent_path(), error);
        if (error) {
            fail(file_, error.message());
        }
        stream_ = create_temporary(file_, temporary_);
    }
    if (!stream_) {
        fail(file_, last_error().message());
    }
    lock_.reset(fdopen(fcntl(fileno(stream_.get()), F_DUPFD_CLOEXEC, 0), "wb"));
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) {
        stream_.reset();
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size()) {
        fail(file_, last_error().message());
    }
}

void AtomicFile::replace(std::size_t offset, std::span<const std::byte> bytes) {
    if (std::fseek(stream_.get(), static_cast<long>(offset), SEEK_SET) != 0) {
        fail(file_, last_error().message());
    }
    write(bytes);
    if (std::fseek(stream_.get(), 0, SEEK_END) != 0) {
        fail(file_, last_error().message());
    }
}

void AtomicFile::finish() {
    // Closing flushes: a full disk may be noticed only here.
    if (std::fclose(stream_.release()) != 0) {
        fail(file_, last_error().message());
    }
    std::error_code error;
    fs::rename(temporary_, file_, error);
    if (error) {
        fail(file_, error.message());
    }
    lock_.reset();
    temporary_.clear();
}

void write_file_atomically(const fs::path& file, std::span<const std::span<const std::byte>> buffers) {
    AtomicFile out(file);
    for (const std::span<const std::byte> buffer : buffers) {
        out.write(buffer);
    }
    out.finish();
}

void write_file_atomically(const fs::path& file, std::span<const std::byte> bytes) {
    write_file_atomically(file, std::span(&bytes, 1));
}

void write_file_atomically(const fs::path& file, std::string_view text) {
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

}  // namespace campuswalk::scene
