#include "tools/campuswalk/run/plan/find_walks.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "config/loader/load_run.h"
#include "engine/report/artifact_path.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

bool is_walk(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() > config::kWalkSuffix.size() && name.ends_with(config::kWalkSuffix) &&
           name.front() != '.';
}

class Search {
public:
    void add(const fs::path& path) {
        std::error_code ignored;
        if (fs::is_directory(path, ignored)) {
            add_folder(path);
        } else {
            files_.insert(
                as_seen_from_here(path).generic_string());  // the loader reports it if it doesn't exist
        }
    }

    std::vector<fs::path> files() const { return {files_.begin(), files_.end()}; }

private:
    void add_folder(const fs::path& folder) {
        std::error_code error;
        if (!seen_.insert(fs::canonical(folder, error)).second) {
            return;
        }
        std::vector<fs::path> entries;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            entries.push_back(entry->path());
        }
        if (error) {
            throw error_about(folder, "folder-unreadable",
                              "walks can't be looked for here: " + error.message());
        }
        std::ranges::sort(entries);  // which of two names of a folder counts must not depend on the disk
        for (const fs::path& entry : entries) {
            std::error_code ignored;
            if (fs::is_directory(entry, ignored)) {
                if (entry.filename().string().front() != '.') {
                    add_folder(entry);
                }
            } else if (is_walk(entry)) {
                files_.insert(as_seen_from_here(entry).generic_string());
            }
        }
    }

    std::set<std::string> files_;
    std::set<fs::path> seen_;
};

fs::path shared_beginning(const fs::path& a, const fs::path& b) {
    fs::path shared;
    const auto [end, other] = std::ranges::mismatch(a, b);
    for (auto part = a.begin(); part != end; ++part) {
        shared /= *part;
    }
    return shared;
}

}  // namespace

fs::path as_seen_from_here(const fs::path& path) {
    std::error_code error;
    const fs::path here = fs::current_path(error);
    if (error || !path.is_absolute()) {
        return path.lexically_normal();
    }
    return path.lexically_normal().lexically_relative(here);
}

std::vector<fs::path> find_walks(const std::vector<fs::path>& paths) {
    Search search;
    for (const fs::path& path : paths) {
        search.add(path);
    }
    return search.files();
}

std::vector<std::string> output_names(const std::vector<fs::path>& files) {
    std::vector<fs::path> absolute;
    fs::path root;
    for (const fs::path& file : files) {
        std::error_code ignored;
        absolute.push_back(fs::absolute(file, ignored).lexically_normal());
        const fs::path folder = absolute.back().parent_path();
        root = absolute.size() == 1 ? folder : shared_beginning(root, folder);
    }
    std::vector<std::string> names;
    names.reserve(absolute.size());
    for (const fs::path& file : absolute) {
        names.push_back(engine::to_artifact_path(
            without_ending(file.lexically_relative(root).generic_string(), config::kWalkSuffix)));
    }
    return names;
}

}  // namespace campuswalk::tools
