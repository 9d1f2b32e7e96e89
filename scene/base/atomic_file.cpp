#include "scene/base/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
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

/// Tries several names: process ids are not unique if containers share a folder.
std::FILE* create_temporary(const fs::path& file, fs::path& temporary) {
    constexpr int kTries = 100;
    std::FILE* stream = nullptr;
    for (int i = 0; i < kTries && stream == nullptr && (i == 0 || errno == EEXIST); ++i) {
        temporary = file;
        temporary += "." + std::to_string(getpid()) + "-" + std::to_string(i) + std::string(kTemporarySuffix);
        stream = std::fopen(temporary.c_str(), "wbx");
    }
    return stream;
}

}  // namespace

AtomicFile::AtomicFile(fs::path file) : file_(std::move(file)) {
    std::error_code error;
    if (fs::exists(file_, error) && !fs::is_regular_file(file_, error)) {
        fail(file_, "it is not a regular file");  // the rename would replace a device
    }
    stream_.reset(create_temporary(file_, temporary_));
    if (!stream_ && errno == ENOENT && file_.has_parent_path()) {
        fs::create_directories(file_.parent_path(), error);
        if (error) {
            fail(file_, error.message());
        }
        stream_.reset(create_temporary(file_, temporary_));
    }
    if (!stream_) {
        fail(file_, last_error().message());
    }
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
