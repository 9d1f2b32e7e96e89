#include "tools/campuswalk/base/read_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace {

constexpr std::uintmax_t kMostReserved = std::uintmax_t{1} << 26U;  // bytes

scene::InputError unreadable(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    return error_about(
        file, "unreadable",
        !std::filesystem::exists(status) ? "there is no such file"
        : std::filesystem::is_other(status)
            ? "it is a pipe, a socket or a device; write what it gives to a file, and name that"
            : "the file can't be read");
}

/// Opening a pipe would wait for a writer, and a device may never end.
std::ifstream open_file(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
        throw unreadable(file);
    }
    return std::ifstream(file, std::ios::binary);
}

}  // namespace

std::vector<std::string> read_lines(const std::filesystem::path& file) {
    std::ifstream stream = open_file(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(std::move(line));
    }
    if (!stream.eof()) {
        throw unreadable(file);
    }
    return lines;
}

std::string read_bytes(const std::filesystem::path& file) {
    std::ifstream stream = open_file(file);
    std::string bytes;
    std::error_code ignored;
    if (const std::uintmax_t size = std::filesystem::file_size(file, ignored); !ignored) {
        bytes.reserve(std::min(size, kMostReserved));  // not more: a file may be nothing but a hole
    }
    std::array<char, 1U << 16U> part;
    do {
        stream.read(part.data(), part.size());
        bytes.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream);
    if (!stream.eof()) {
        throw unreadable(file);
    }
    return bytes;
}

}  // namespace campuswalk::tools
