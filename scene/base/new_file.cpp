#include "scene/base/new_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
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
std::FILE* create(const fs::path& file) {
    return std::fopen(file.c_str(), "wbxe");
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

}  // namespace

void write_new_file(const fs::path& file, std::string_view text) {
    std::FILE* stream = create(file);
    if (stream == nullptr && make_room(file)) {
        stream = create(file);
    }
    if (stream == nullptr) {
        fail_to_write(file, error_of_call());
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
    std::error_code reason = written ? std::error_code() : error_of_call();
    if (std::fclose(stream) != 0 && !reason) {  // it flushes: a full disk may be noticed only here
        reason = error_of_call();
    }
    if (reason) {
        unlink(file.c_str());
        fail_to_write(file, reason);
    }
}

}  // namespace campuswalk::scene
