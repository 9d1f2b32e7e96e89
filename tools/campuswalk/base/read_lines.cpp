#include "tools/campuswalk/base/read_lines.h"

#include <fstream>
#include <utility>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

std::vector<std::string> read_lines(const std::filesystem::path& file) {
    std::error_code ignored;
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(std::move(line));
    }
    if (!stream.eof()) {
        throw error_about(
            file, "unreadable",
            std::filesystem::exists(file, ignored) ? "the file can't be read" : "there is no such file");
    }
    return lines;
}

}  // namespace campuswalk::tools
