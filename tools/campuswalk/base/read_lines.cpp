#include "tools/campuswalk/base/read_lines.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace {

scene::InputError unreadable(const std::filesystem::path& file) {
    std::error_code ignored;
    return error_about(
        file, "unreadable",
        std::filesystem::exists(file, ignored) ? "the file can't be read" : "there is no such file");
}

}  // namespace

std::vector<std::string> read_lines(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
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
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        throw unreadable(file);
    }
    return bytes;
}

}  // namespace campuswalk::tools
