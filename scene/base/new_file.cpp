#include "scene/base/new_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace campuswalk::scene {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const fs::path& file, const std::error_code& reason) {
    throw std::runtime_error("can't write '" + file.string() + "': " + reason.message());
}

std::error_code error_of_call() {
    return {errno, std::generic_category()};
}

/// Null if there is such a file, or a link of this name.
FileStream create(const fs::path& file) {
    return FileStream(std::fopen(file.c_str(), "wbxe"));
}

/// Whether what hinders is out of the way: a file of this name, or a folder that is missing.
bool make_room(const fs::path& file) {
    if (errno == EEXIST) {
        struct stat status {};
        if (lstat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) {
            errno = EEXIST;
            return false;
        }
        return unlink(file.c_str()) == 0 || errno == ENOENT;
    }
    std::error_code error;
    if (errno == ENOENT && file.has_parent_path()) {
        fs::create_directories(file.parent_path(), error);
        if (error) {
            fail_to_write(file, error);
        }
        return true;
    }
    return false;
}

FileStream stream_of(int descriptor, const fs::path& file) {
    FileStream stream(fdopen(descriptor, "wb"));
    if (!stream) {
        const std::error_code reason = error_of_call();
        close(descriptor);
        fail_to_write(file, reason);
    }
    return stream;
}

/// A file that can't be removed from its folder. Null if it can't be written either.
FileStream empty_in_place(const fs::path& file) {
    const int reason = errno;
    const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) {
        errno = reason;  // of the folder
        return nullptr;
    }
    FileStream stream = stream_of(descriptor, file);
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink != 1 ||
        ftruncate(descriptor, 0) != 0) {
        errno = reason;
        return nullptr;
    }
    return stream;
}

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

FileStream open_new_file(const fs::path& file) {
    constexpr int kMostTries = 1000;  // other processes may write the same file
    FileStream stream = create(file);
    for (int tries = 0; !stream && tries < kMostTries && make_room(file); ++tries) {
        stream = create(file);
    }
    if (!stream && (errno == EACCES || errno == EPERM || errno == EBUSY || errno == EROFS)) {
        stream = empty_in_place(file);
    }
    if (!stream) {
        fail_to_write(file, error_of_call());
    }
    return stream;
}

bool is_stream(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
        return true;
    }
    constexpr int kMostLinks = 40;  // as the kernel's
    fs::path at = fs::absolute(path, error).lexically_normal();
    for (int i = 0; i < kMostLinks; ++i) {
        // Whatever /dev/stdout and /dev/fd/1 lead to is open already.
        const fs::path folder = fs::weakly_canonical(at.parent_path(), error);
        if (is_below(folder, "/proc") || is_below(folder, "/dev/fd")) {
            return true;
        }
        const fs::path target = fs::read_symlink(at, error);
        if (error) {
            break;
        }
        at = (folder / target).lexically_normal();
    }
    return false;
}

FileStream open_stream(const fs::path& path) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_TRUNC);
    if (descriptor < 0) {
        fail_to_write(path, error_of_call());
    }
    return stream_of(descriptor, path);
}

void write_new_file(const fs::path& file, std::string_view text) {
    FileStream stream = open_new_file(file);
    const bool written = std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size();
    std::error_code reason = written ? std::error_code() : error_of_call();
    if (std::fclose(stream.release()) != 0 && !reason) {  // it flushes: a full disk may be noticed only here
        reason = error_of_call();
    }
    if (reason) {
        unlink(file.c_str());
        fail_to_write(file, reason);
    }
}

}  // namespace campuswalk::scene
