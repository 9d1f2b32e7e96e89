#include "tests/engine/render/scratch_folder.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace campuswalk::engine::render::test {

ScratchFolder::ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "campuswalk-render-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw std::runtime_error("can't make a folder like " + pattern);
    }
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::filesystem::path> ScratchFolder::contents() const {
    std::vector<std::filesystem::path> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
        all.push_back(std::filesystem::relative(entry.path(), path_));
    }
    std::ranges::sort(all);
    return all;
}

}  // namespace campuswalk::engine::render::test
