#include "engine/report/report_paths.h"

#include <filesystem>
#include <functional>
#include <utility>

namespace campuswalk::engine {

namespace {

namespace fs = std::filesystem;

using PathChange = std::function<std::string(const std::string& path)>;

std::string path_in_run(const std::string& start, const std::string& path) {
    return fs::path(path).lexically_relative(start).generic_string();
}

/// Options such as --grep are no paths.
bool names_file(const scene::SourceMark& mark) {
    return !mark.file.empty() && !mark.file.starts_with("--");
}

WalkResult with_changed_paths(WalkResult result, const PathChange& change) {
    if (result.id.starts_with(result.file)) {
        result.id = change(result.file) + result.id.substr(result.file.size());
    }
    result.file = change(result.file);
    if (!result.config.empty()) {
        result.config = change(result.config);
    }
    const auto change_in = [&](auto& all) {
        for (auto& each : all) {
            each.mark.file = names_file(each.mark) ? change(each.mark.file) : each.mark.file;
        }
    };
    change_in(result.failures);
    change_in(result.diagnostics);
    return result;
}

}  // namespace

std::string path_in_repository(const std::string& start, const std::string& path) {
    return start.empty() ? path : (fs::path(start) / path).lexically_normal().generic_string();
}

std::string published_path(const std::string& folder, const std::string& path) {
    return folder == ".." || folder.starts_with("../") ? path : path_in_repository(folder, path);
}

WalkResult with_paths_in_repository(const std::string& start, WalkResult result) {
    return start.empty() ? std::move(result)
                         : with_changed_paths(std::move(result), [&](const std::string& path) {
                               return path_in_repository(start, path);
                           });
}

WalkResult with_paths_in_run(const std::string& start, WalkResult result) {
    return start.empty() ? std::move(result)
                         : with_changed_paths(std::move(result), [&](const std::string& path) {
                               return path_in_run(start, path);
                           });
}

}  // namespace campuswalk::engine
