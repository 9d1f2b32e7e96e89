#include "tools/campuswalk/base/walk_folder.h"

#include <system_error>
#include <vector>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// The entries of one folder; none if another process has removed it meanwhile.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        entries.push_back(*entry);
    }
    if (error && error != std::errc::no_such_file_or_directory) {
        throw error_about(folder, "folder-unreadable", "what is in it can't be listed: " + error.message());
    }
    return entries;
}

}  // namespace

void walk_folder(const fs::path& folder, const std::function<bool(const fs::directory_entry& entry)>& visit) {
    std::vector<fs::path> folders = {folder};
    while (!folders.empty()) {
        const fs::path next = std::move(folders.back());
        folders.pop_back();
        for (const fs::directory_entry& entry : entries_of(next)) {
            std::error_code ignored;
            if (visit(entry) && entry.symlink_status(ignored).type() == fs::file_type::directory) {
                folders.push_back(entry.path());
            }
        }
    }
}

}  // namespace campuswalk::tools
