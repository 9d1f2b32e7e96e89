#include "tools/campuswalk/base/read_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include "scene/base/why_unreadable.h"
#include "tools/campuswalk/base/file_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace {

constexpr std::uintmax_t kMostReserved = std::uintmax_t{1} << 26U;  // bytes

std::ifstream open_file(const std::filesystem::path& file) {
    if (const std::string why = scene::why_unreadable(file); !why.empty()) {
        throw error_about(file, "unreadable", why);
    }
    return std::ifstream(file, std::ios::binary);
}

void check_end(const std::ifstream& stream, const std::filesystem::path& file) {
    if (!stream.eof()) {
        throw error_about(file, "unreadable", "it can't be read to its end");
    }
}

}  // namespace

std::vector<std::string> read_lines(const std::filesystem::path& file, const LineCheck& check) {
    std::ifstream stream = open_file(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        const int number = static_cast<int>(lines.size()) + 1;
        if (line.size() > kLongestLine) {
            throw long_line(file, number);
        }
        if (check) {
            check(number, line);
        }
        lines.push_back(std::move(line));
    }
    check_end(stream, file);
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
    check_end(stream, file);
    return bytes;
}

}  // namespace campuswalk::tools
