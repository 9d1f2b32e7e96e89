#include "scene/base/new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace campuswalk::scene {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kMode = 0666;  // less the process's mask

[[noreturn]] void fail_to_write(const fs::path& file, const std::error_code& reason) {
    throw std::runtime_error("can't write '" + file.string() + "': " + reason.message());
}

std::error_code error_of_call() {
    return {errno, std::generic_category()};
}

int create(const fs::path& file) {
    return open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
}

/// Whether what hinders is out of the way: a file of this name, or a folder that is missing.
bool make_room(const fs::path& file) {
    if (errno == EEXIST) {
        return unlink(file.c_str()) == 0;
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

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

void write_new_file(const fs::path& file, std::string_view text) {
    int descriptor = create(file);
    if (descriptor < 0 && make_room(file)) {
        descriptor = create(file);
    }
    if (descriptor < 0) {
        fail_to_write(file, error_of_call());
    }
    const bool written = write_all(descriptor, text);
    std::error_code reason = written ? std::error_code() : error_of_call();
    if (close(descriptor) != 0 && !reason) {
        reason = error_of_call();
    }
    if (reason) {
        unlink(file.c_str());
        fail_to_write(file, reason);
    }
}

}  // namespace campuswalk::scene
