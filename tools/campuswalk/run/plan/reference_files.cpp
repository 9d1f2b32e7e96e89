#include "tools/campuswalk/run/plan/reference_files.h"

#include <string>

#include "config/loader/search_paths.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/logs/golden_log.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

std::set<fs::path> reference_files(const fs::path& folder) {
    std::error_code ignored;
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        files.insert(entry.path());
    }
    return files;
}

std::vector<scene::Diagnostic> reference_errors(const fs::path& walk_file) {
    const config::ReadRoots roots = config::read_roots(walk_file, search_paths());
    const fs::path folder = golden_log_file(walk_file, "").parent_path();
    std::error_code ignored;
    scene::DiagnosticList errors;
    for (const fs::path& file : reference_files(folder)) {
        const scene::SourceMark mark{file.generic_string(), 0, 0};
        if (const std::string why = roots.why_unreadable(file); !why.empty()) {
            errors.error(mark, "outside-project", "this golden file " + why);
        } else if (!fs::is_regular_file(file, ignored)) {
            errors.error(mark, "unreadable", "this golden file isn't a regular file");
        } else if (fs::file_size(file, ignored) > kMaxReferenceBytes) {
            errors.error(mark, "too-large",
                         "golden files may have " + std::to_string(kMaxReferenceBytes >> 20U) + " MB");
        }
    }
    return errors.all();
}

}  // namespace campuswalk::tools
