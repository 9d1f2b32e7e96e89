#include "tools/campuswalk/base/read_below.h"

#include <system_error>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/read_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

std::optional<std::string> read_below(const fs::path& folder, const std::string& path) {
    fs::path file = folder;
    fs::file_status status;
    for (const fs::path& part : fs::path(path)) {
        if (part == ".." || part.is_absolute()) {
            return std::nullopt;
        }
        file /= part;
        std::error_code failed;
        status = fs::symlink_status(file, failed);
        if (failed || fs::is_symlink(status)) {
            return std::nullopt;
        }
    }
    if (!fs::is_regular_file(status)) {
        return std::nullopt;
    }
    constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 28U;
    std::error_code failed;
    if (fs::file_size(file, failed) > kMostBytes || failed) {
        return std::nullopt;
    }
    try {
        return read_bytes(file);
    } catch (const scene::InputError&) {
        return std::nullopt;
    }
}

}  // namespace campuswalk::tools
