#include "scene/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

namespace campuswalk::scene {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw std::runtime_error("can't write '" + file.string() + "': " + reason);
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

/// What went wrong, nothing if nothing did.
std::error_code write_parts(std::FILE* stream, std::span<const std::span<const std::byte>> parts) {
    std::error_code error;
    for (const std::span<const std::byte> part : parts) {
        if (!error && std::fwrite(part.data(), 1, part.size(), stream) != part.size()) {
            error = last_error();
        }
    }
    // Closing flushes: a full disk may only show here.
    if (std::fclose(stream) != 0 && !error) {
        error = last_error();
    }
    return error;
}

/// A new file beside it. Process numbers alone are not unique where containers share a folder.
std::FILE* open_part(const fs::path& file, fs::path& part) {
    constexpr int kTries = 100;
    std::FILE* stream = nullptr;
    for (int i = 0; i < kTries && stream == nullptr && (i == 0 || errno == EEXIST); ++i) {
        part = file;
        part += "." + std::to_string(getpid()) + "-" + std::to_string(i) + std::string(kPartSuffix);
        stream = std::fopen(part.c_str(), "wbx");
    }
    return stream;
}

}  // namespace

void write_whole_file(const fs::path& file, std::span<const std::span<const std::byte>> parts) {
    std::error_code error;
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
        fail(file, "it is not a regular file");  // the rename would put one in its place
    }
    if (file.has_parent_path()) {
        fs::create_directories(file.parent_path(), error);
        if (error) {
            fail(file, error.message());
        }
    }
    fs::path part;
    std::FILE* stream = open_part(file, part);
    if (stream == nullptr) {
        fail(file, last_error().message());
    }
    error = write_parts(stream, parts);
    if (!error) {
        fs::rename(part, file, error);
    }
    if (error) {
        std::error_code ignored;
        fs::remove(part, ignored);
        fail(file, error.message());
    }
}

void write_whole_file(const fs::path& file, std::span<const std::byte> bytes) {
    write_whole_file(file, std::span(&bytes, 1));
}

void write_whole_file(const fs::path& file, std::string_view text) {
    write_whole_file(file, std::as_bytes(std::span(text)));
}

}  // namespace campuswalk::scene
