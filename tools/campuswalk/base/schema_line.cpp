#include "tools/campuswalk/base/schema_line.h"

#include <system_error>

#include "config/loader/values/read_roots.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

std::string schema_line(const fs::path& file, std::string_view schema) {
    std::error_code ignored;
    const fs::path project = config::ReadRoots(file, {}).project();
    const fs::path folder = fs::weakly_canonical(fs::absolute(file), ignored).parent_path();
    for (fs::path at = folder;; at = at.parent_path()) {
        const fs::path found = at / "schema" / schema;
        if (fs::is_regular_file(found, ignored)) {
            return "# yaml-language-server: $schema=" + found.lexically_relative(folder).generic_string() +
                   "\n";
        }
        if (at == project || at == at.root_path()) {
            return "";
        }
    }
}

}  // namespace campuswalk::tools
