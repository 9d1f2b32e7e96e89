#include "scene/base/installation.h"

#include <system_error>

namespace campuswalk::scene {

namespace fs = std::filesystem;

fs::path installed_data() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return (program.parent_path() / CAMPUSWALK_DATA_FROM_PROGRAM).lexically_normal();
}

}  // namespace campuswalk::scene
