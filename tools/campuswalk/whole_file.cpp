#include "tools/campuswalk/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::error_code& reason) {
    throw std::runtime_error("can't write '" + file.string() + "': " + reason.message());
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

/// What went wrong, nothing if nothing did.
std::error_code write_bytes(const fs::path& file, std::string_view bytes) {
    std::FILE* stream = std::fopen(file.c_str(), "wb");
    if (stream == nullptr) {
        return last_error();
    }
    std::error_code error;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream) != bytes.size()) {
        error = last_error();
    }
    // Closing flushes: a full disk may only show here.
    if (std::fclose(stream) != 0 && !error) {
        error = last_error();
    }
    return error;
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view bytes) {
    std::error_code error;
    if (file.has_parent_path()) {
        fs::create_directories(file.parent_path(), error);
        if (error) {
            fail(file, error);
        }
    }
    fs::path part = file;
    part += "." + std::to_string(getpid()) + ".part";
    error = write_bytes(part, bytes);
    if (!error) {
        fs::rename(part, file, error);
    }
    if (error) {
        std::error_code ignored;
        fs::remove(part, ignored);
        fail(file, error);
    }
}

}  // namespace campuswalk::tools
