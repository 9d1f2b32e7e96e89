#include "tools/campuswalk/run/html/campus_bundle.h"

#include <span>
#include <utility>

#include "engine/html_report/campus_entry.h"
#include "engine/html_report/foreign_json.h"
#include "scene/base/atomic_file.h"
#include "scene/base/printable.h"
#include "scene/cache/content_hash.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_below.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/run/html/packed_glb.h"
#include "tools/campuswalk/run/output/output_folder.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr double kError = 0.05;  // metres
constexpr const char* kGlbEnding = ".glb.gz";

}  // namespace

engine::ReportCampus report_campus(const scene::Campus& campus, const std::string& file,
                                   ReportGeometry geometry) {
    engine::ReportCampus shown;
    shown.entry = engine::campus_entry(campus, file);
    if (geometry == ReportGeometry::exact || geometry == ReportGeometry::simplified) {
        shown.error = geometry == ReportGeometry::exact ? 0.0 : kError;
        shown.glb = packed_glb(campus, shown.error);
    }
    return shown;
}

std::string bundle_name(const std::string& file) {
    constexpr std::size_t kDigits = 8;
    const std::string hash = scene::to_string(scene::hash_of(std::as_bytes(std::span(file))));
    return std::string(kBundleFolder) + "/" +
           without_ending(fs::path(file).filename().generic_string(), ".campus.yaml") + "-" +
           hash.substr(0, kDigits);
}

void write_bundle(const fs::path& output, const std::string& file, const engine::ReportCampus& campus) {
    const std::string name = bundle_name(file);
    Json glb;
    if (!campus.glb.empty()) {
        glb = fs::path(name + kGlbEnding).filename().generic_string();
        scene::write_file_atomically(output / (name + kGlbEnding), campus.glb);
    }
    const std::string text = "{\"campuswalk_campus\":1,\"glb\":" + json_text(glb) +
                             ",\"error\":" + json_text(campus.error) + ",\"campus\":{" + campus.entry +
                             "}}\n";
    scene::write_file_atomically(output / (name + ".json"), scene::printable_json(text));
}

std::optional<engine::ReportCampus> read_bundle(const fs::path& output, const std::string& file) {
    const std::string name = bundle_name(file);
    const std::optional<std::string> text = read_below(output, name + ".json");
    const std::optional<Json> json = text ? engine::parse_foreign(*text) : std::nullopt;
    if (!json || !engine::has_numbers(*json, {"campuswalk_campus", "error"}) ||
        (*json)["campuswalk_campus"] != 1 || !json->contains("campus") ||
        !engine::is_campus_entry((*json)["campus"])) {
        return std::nullopt;
    }
    engine::ReportCampus campus;
    const std::string entry = (*json)["campus"].dump(-1, ' ', false, Json::error_handler_t::replace);
    campus.entry = entry.substr(1, entry.size() - 2);
    campus.error = (*json)["error"].get<double>();
    if (engine::has_strings(*json, {"glb"})) {
        campus.glb = read_below(output, name + kGlbEnding).value_or("");
    }
    return campus;
}

}  // namespace campuswalk::tools
