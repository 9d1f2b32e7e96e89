#include "tools/campuswalk/run/output/shard_artifacts.h"

#include <charconv>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "scene/base/new_file.h"
#include "tools/campuswalk/base/read_below.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/run/output/output_folder.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// The number that a name such as campuswalk-3 ends in; nullopt without one.
std::optional<int> number_of(std::string_view name) {
    const std::size_t dash = name.rfind('-');
    int number = 0;
    const char* end = name.data() + name.size();
    if (dash == std::string_view::npos ||
        std::from_chars(name.data() + dash + 1, end, number) != std::from_chars_result{end, std::errc()}) {
        return std::nullopt;
    }
    return number > 0 ? std::optional(number) : std::nullopt;
}

std::multimap<int, fs::path> numbered_folders(const fs::path& folder) {
    std::multimap<int, fs::path> folders;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::optional<int> number = number_of(entry->path().filename().native());
        if (number && entry->symlink_status().type() == fs::file_type::directory) {
            folders.emplace(*number, entry->path());
        }
    }
    if (error) {
        throw error_about(folder, "missing-file",
                          "the shards' artifacts can't be looked for here: " + error.message());
    }
    return folders;
}

/// Whether it can be what html reports show of a campus.
bool is_bundle(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    return entry.symlink_status().type() == fs::file_type::regular && !name.starts_with('.') &&
           (name.ends_with(".json") || name.ends_with(".glb.gz"));
}

std::vector<std::string> bundles_in(const fs::path& folder) {
    std::vector<std::string> bundles;
    std::error_code error;
    for (fs::directory_iterator entry(folder / kBundleFolder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (is_bundle(*entry)) {
            bundles.push_back(kBundleFolder + ("/" + entry->path().filename().string()));
        }
    }
    return bundles;
}

/// Which files are to be copied, and each from where.
class Gathering {
public:
    void add(const fs::path& folder, const std::string& path) {
        const std::optional<std::string> bytes = read_below(folder, path);
        if (!bytes) {
            ++missing_;
            return;
        }
        const auto [first, is_new] = folders_.emplace(path, folder);
        if (!is_new && read_below(first->second, path) != bytes) {
            throw error_about(
                folder / path, "foreign-results",
                "another shard's artifact has a different file of this name; run the shards again");
        }
    }

    void copy_to(const fs::path& output) const {
        for (const auto& [path, folder] : folders_) {
            if (const std::optional<std::string> bytes = read_below(folder, path)) {
                scene::write_new_file(output / path, *bytes);
            }
        }
    }
    std::size_t missing() const { return missing_; }

private:
    std::map<std::string, fs::path> folders_;
    std::size_t missing_ = 0;
};

}  // namespace

std::vector<ShardArtifact> open_shard_artifacts(const fs::path& folder,
                                                const std::optional<std::string>& key) {
    std::vector<ShardArtifact> artifacts;
    for (const auto& [number, path] : numbered_folders(folder)) {
        const fs::path file = path / ("results-" + std::to_string(number) + ".jsonl");
        std::error_code ignored;
        if (!fs::is_regular_file(fs::symlink_status(file, ignored))) {
            continue;  // a job that didn't come that far: its shard is missing
        }
        std::optional<ResultFile> results = ResultFile::open(file, key);
        if (!results) {
            throw error_about(file, "bad-report", "this isn't what --reporter jsonl=FILE writes");
        }
        if (results->plan().shard != number) {
            throw error_about(file, "foreign-results",
                              "these are the results of shard " + std::to_string(results->plan().shard) +
                                  ", and only those of shard " + std::to_string(number) +
                                  " are taken from this artifact");
        }
        artifacts.push_back({path, std::move(*results)});
    }
    if (artifacts.empty()) {
        throw error_about(
            folder, "missing-file",
            "there is no folder NAME-N with results-N.jsonl in here, as the artifact of shard N has them");
    }
    return artifacts;
}

std::size_t gather_files(const std::vector<ShardArtifact>& artifacts, const fs::path& output) {
    Gathering gathering;
    for (const ShardArtifact& artifact : artifacts) {
        artifact.results.for_each([&](engine::WalkResult&& result) {
            for (const engine::Artifact& file : result.artifacts) {
                if (file.path.find('/') == std::string::npos) {  // where the merged reports go
                    throw error_about(artifact.results.file(), "foreign-results",
                                      result.file + " has \"" + file.path +
                                          "\" among its files, and walks write to folders of their own");
                }
                gathering.add(artifact.folder, file.path);
            }
        });
        for (const std::string& bundle : bundles_in(artifact.folder)) {
            gathering.add(artifact.folder, bundle);
        }
    }
    gathering.copy_to(output);
    return gathering.missing();
}

}  // namespace campuswalk::tools
