#include <nlohmann/json.hpp>

#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json or_null(const std::optional<Value>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

const char* name_of(UpdateSnapshots mode) {
    switch (mode) {
        case UpdateSnapshots::all:
            return "all";
        case UpdateSnapshots::changed:
            return "changed";
        case UpdateSnapshots::missing:
            return "missing";
        case UpdateSnapshots::none:
            return "none";
    }
    return "";
}

ordered_json reports_of(const RunSettings& settings) {
    ordered_json reports = ordered_json::array();
    for (const ReportTarget& target : settings.reports) {
        reports.push_back(
            {{"name", target.name},
             {"file", target.file ? ordered_json(target.file->generic_string()) : ordered_json()}});
    }
    return reports;
}

ordered_json projects_of(const RunSettings& settings) {
    ordered_json projects = ordered_json::array();
    for (const config::ProjectConfig& project : settings.projects) {
        if (!project.name.empty()) {
            projects.push_back(project.name);
        }
    }
    return projects;
}

}  // namespace

std::string to_json(const RunSettings& settings, const RunOptions& options) {
    ordered_json json;
    json["config"] =
        settings.config.empty() ? ordered_json() : ordered_json(settings.config.generic_string());
    json["walks"] = ordered_json::array();
    for (const std::filesystem::path& path : settings.paths) {
        json["walks"].push_back(path.generic_string());
    }
    json["grep"] = or_null(options.grep);
    json["grep_invert"] = or_null(options.grep_invert);
    json["tags"] = options.tags;
    json["projects"] = projects_of(settings);
    json["shard"] = settings.shard ? ordered_json(std::to_string(settings.shard->index + 1) + "/" +
                                                  std::to_string(settings.shard->count))
                                   : ordered_json();
    json["workers"] = settings.workers;
    json["max_failures"] = or_null(settings.max_failures);
    json["repeat_each"] = options.repeat_each;
    json["require_identical"] = options.require_identical;
    json["forbid_only"] = settings.forbid_only;
    json["timeout"] = or_null(settings.timeout);
    json["kill_after"] = or_null(settings.kill_after);
    json["output"] = settings.output.generic_string();
    json["reporters"] = reports_of(settings);
    json["update_snapshots"] = name_of(settings.update);
    const engine::ImageTolerance& tolerance = settings.tolerance;
    json["snapshots"] = {{"threshold", tolerance.threshold},
                         {"max_diff_pixels", or_null(tolerance.max_diff_pixels)},
                         {"max_diff_pixel_ratio", or_null(tolerance.max_diff_pixel_ratio)},
                         {"min_tile_ssim", tolerance.min_tile_ssim},
                         {"masks", ordered_json::array()}};
    for (const engine::PixelBox& mask : tolerance.masks) {
        json["snapshots"]["masks"].push_back({mask.x, mask.y, mask.width, mask.height});
    }
    json["color"] = settings.color;
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace campuswalk::tools
