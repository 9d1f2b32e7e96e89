#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

namespace {

template <typename Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json reports_of(const RunSettings& settings) {
    Json reports = Json::array();
    for (const ReportTarget& target : settings.reports) {
        reports.push_back(
            {{"name", target.name}, {"file", target.file ? Json(target.file->generic_string()) : Json()}});
    }
    return reports;
}

Json projects_of(const RunSettings& settings) {
    Json projects = Json::array();
    for (const config::ProjectConfig& project : settings.projects) {
        if (!project.name.empty()) {
            projects.push_back(project.name);
        }
    }
    return projects;
}

}  // namespace

Json json_of(const engine::ImageTolerance& tolerance) {
    Json json = {{"threshold", tolerance.threshold},
                 {"max_diff_pixels", or_null(tolerance.max_diff_pixels)},
                 {"max_diff_pixel_ratio", or_null(tolerance.max_diff_pixel_ratio)},
                 {"min_tile_ssim", tolerance.min_tile_ssim},
                 {"masks", Json::array()}};
    for (const engine::PixelBox& mask : tolerance.masks) {
        json["masks"].push_back({mask.x, mask.y, mask.width, mask.height});
    }
    return json;
}

std::string to_json(const RunSettings& settings, const RunOptions& options) {
    Json json;
    json["config"] = settings.config.empty() ? Json() : Json(settings.config.generic_string());
    json["walks"] = Json::array();
    for (const std::filesystem::path& path : settings.paths) {
        json["walks"].push_back(path.generic_string());
    }
    json["grep"] = or_null(options.grep);
    json["grep_invert"] = or_null(options.grep_invert);
    json["tags"] = options.tags;
    json["projects"] = projects_of(settings);
    json["shard"] =
        settings.shard
            ? Json(std::to_string(settings.shard->index + 1) + "/" + std::to_string(settings.shard->count))
            : Json();
    json["workers"] = settings.workers;
    json["max_failures"] = or_null(settings.max_failures);
    json["repeat_each"] = options.repeat_each;
    json["require_identical"] = options.require_identical;
    json["forbid_only"] = settings.forbid_only;
    json["strict"] = settings.strict;
    json["min_cases"] = settings.min_cases;
    json["timeout"] = or_null(settings.timeout);
    json["kill_after"] = or_null(settings.kill_after);
    json["output"] = settings.output.generic_string();
    json["reporters"] = reports_of(settings);
    for (const auto& [name, mode] : update_modes()) {
        if (mode == settings.update) {
            json["update_snapshots"] = name;
        }
    }
    json["snapshots"] = json_of(settings.tolerance);
    json["color"] = settings.color;
    return json_text(json, 2);
}

}  // namespace campuswalk::tools
