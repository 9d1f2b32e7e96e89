#include "tools/campuswalk/html/run_files.h"

#include <algorithm>
#include <system_error>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/read_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

std::optional<std::string> read_below(const fs::path& folder, const std::string& path) {
    std::error_code failed;
    const fs::path root = fs::canonical(folder, failed);
    const fs::path file = failed ? fs::path() : fs::canonical(root / path, failed);
    if (failed || std::ranges::mismatch(root, file).in1 != root.end() || !fs::is_regular_file(file, failed)) {
        return std::nullopt;
    }
    try {
        return read_bytes(file);
    } catch (const scene::InputError&) {
        return std::nullopt;
    }
}

}  // namespace campuswalk::tools
