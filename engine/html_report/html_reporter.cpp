#include "engine/html_report/html_reporter.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/html_report/walk_row.h"
#include "engine/report/report_paths.h"
#include "engine/report/result_json.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

/// A picture as a report contains it.
struct ReportImage {
    std::string bytes;
    std::string media_type;
};

constexpr int kMaxWidth = 1280;    // pixels
constexpr int kMaxHeight = 16383;  // pixels, WebP's own limit
constexpr float kQuality = 80.0F;  // of 100

bool is_compared(const Artifact& artifact) {
    const std::string& path = artifact.path;
    return path.ends_with("-actual.png") || path.ends_with("-expected.png") || path.ends_with("-diff.png");
}

/// Whether a report shows this file: a still picture.
bool is_still_image(const Artifact& artifact) {
    return artifact.media_type == "image/png";
}

/// Encodes a picture as WebP. Pictures that are compared keep every pixel; others lose what is hard to see
/// and are at most 1280 pixels wide.
ReportImage report_image(const Artifact& artifact, const scene::PixelView& pixels) {
    if (is_compared(artifact)) {
        const scene::Pixels whole = scene::shrunk_to_fit(pixels, kMaxHeight, kMaxHeight);
        return {scene::encode_webp_lossless(whole.view()), "image/webp"};
    }
    const scene::Pixels shown = scene::shrunk_to_fit(pixels, kMaxWidth, kMaxHeight);
    return {scene::encode_webp(shown.view(), kQuality), "image/webp"};
}

/// Bytes that aren't UTF-8 can't be written in JSON: they become U+FFFD.
std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// JSON of several lines on one: its strings have no line ends.
std::string on_one_line(std::string text) {
    std::erase(text, '\n');
    std::erase(text, '\r');
    return text;
}

std::optional<std::string> recording_of(const WalkResult& result, const FileReader& read) {
    const auto artifact = std::ranges::find(result.artifacts, "recording", &Artifact::name);
    return artifact == result.artifacts.end() ? std::nullopt : read(artifact->path);
}

}  // namespace

HtmlReporter::HtmlReporter(TextSink sink, HtmlInputs inputs)
    : inputs_(std::move(inputs)), page_(std::move(sink), inputs_.viewer), details_(page_) {}

void HtmlReporter::begin(const RunPlan& plan) {
    planned_ = plan.cases;
    page_.begin(inputs_.title);
}

void HtmlReporter::result(const WalkResult& result) {
    Details details = details_of(result, inputs_.read_artifact);
    details_.add(details.line, std::move(details.row), rows_);
    if (inputs_.against) {
        compare(result, details.path);
    }
    ++walks_;
}

HtmlReporter::Details HtmlReporter::details_of(const WalkResult& result, const FileReader& read_artifact) {
    Details details;
    std::optional<std::string> recording = recording_of(result, read_artifact);
    details.path = recording ? read_recorded_path(*recording) : std::nullopt;
    WalkPlacement placement;
    placement.campus = campus_of(result, details.path);
    if (details.path) {
        placement.plan = plan_of(*details.path);
    }
    const std::string images = images_of(result, read_artifact, placement.thumbnail);
    const WalkResult shown = with_paths_in_repository(inputs_.start, result);
    details.line = "{\"result\":" + to_json_line(shown) +
                   ",\"recording\":" + (details.path ? on_one_line(std::move(*recording)) : "null") +
                   ",\"pictures\":" + images + ",\"source\":" + source_of(result) + "}";
    details.row = open_walk_row(shown, placement);
    return details;
}

/// Chunk numbers by path. The thumbnail is the first picture, or of a failed walk the one that shows what was
/// in the way.
std::string HtmlReporter::images_of(const WalkResult& result, const FileReader& read_artifact,
                                    std::ptrdiff_t& thumbnail) {
    std::vector<std::string> paths;
    std::vector<const Artifact*> shown;
    for (const Artifact& artifact : result.artifacts) {
        if (is_still_image(artifact) && std::ranges::find(paths, artifact.path) == paths.end()) {
            paths.push_back(artifact.path);
            shown.push_back(&artifact);
        }
    }
    Json chunks = Json::object();
    inputs_.read_images(read_artifact, paths, [&](std::size_t i, const scene::PixelView& pixels) {
        const ReportImage image = report_image(*shown[i], pixels);
        const std::size_t chunk = page_.add_image(image.bytes, image.media_type);
        chunks[paths[i]] = chunk;
        if (thumbnail < 0 || (result.outcome == Outcome::failed && paths[i].ends_with("-beside.png"))) {
            thumbnail = static_cast<std::ptrdiff_t>(chunk);
        }
    });
    return dumped(chunks);
}

/// The text of the walk file, and of others that failures and diagnostics point to.
std::string HtmlReporter::source_of(const WalkResult& result) const {
    constexpr std::size_t kMostBytes = std::size_t{1} << 18U;
    std::set<std::string> files = {result.file};
    for (const Failure& failure : result.failures) {
        files.insert(failure.mark.file);
    }
    for (const scene::Diagnostic& diagnostic : result.diagnostics) {
        files.insert(diagnostic.mark.file);
    }
    Json source = Json::object();
    for (const std::string& file : files) {
        if (std::optional<std::string> text = inputs_.read_source(file); text && text->size() <= kMostBytes) {
            source[path_in_repository(inputs_.start, file)] = std::move(*text);
        }
    }
    return source.empty() ? "null" : dumped(source);
}

std::ptrdiff_t HtmlReporter::campus_of(const WalkResult& result, const std::optional<RecordedPath>& path) {
    const std::string file = path ? path->campus_file : inputs_.campus_file_of(result);
    if (file.empty()) {
        return -1;
    }
    const auto [known, is_new] = campuses_.try_emplace(file, -1);
    if (is_new) {
        if (const std::optional<ReportCampus> campus = inputs_.find_campus(file)) {
            known->second = static_cast<std::ptrdiff_t>(campus_entries_.size());
            names_.try_emplace(result.campus, known->second);
            add_campus(*campus);
        }
    }
    return known->second;
}

void HtmlReporter::add_campus(const ReportCampus& campus) {
    std::string geometry = "null";
    if (!campus.glb.empty()) {
        geometry = dumped({{"chunk", page_.add_packed(campus.glb)},
                           {"kind", campus.error > 0.0 ? "simplified" : "exact"},
                           {"error", campus.error}});
    }
    campus_entries_.push_back("{" + campus.entry + ",\"geometry\":" + geometry + "}");
}

void HtmlReporter::compare(const WalkResult& result, const std::optional<RecordedPath>& path) {
    seen_.push_back(std::hash<std::string>()(result.id));
    const std::optional<WalkResult> other = inputs_.against->find(result.id);
    if (other && (other->outcome != result.outcome || other->hash != result.hash)) {
        add_compared(*other, walks_, path);
    }
}

void HtmlReporter::add_compared(const WalkResult& other, std::size_t index,
                                const std::optional<RecordedPath>& path) {
    Details details = details_of(other, inputs_.against->read_artifact);
    std::string parts_at = "-1";  // there is nothing to compare
    if (path && details.path) {
        const std::optional<Tick> tick = parting_tick(*path, *details.path);
        parts_at = tick ? std::to_string(*tick) : "null";
    }
    details.row += ",\"index\":" + std::to_string(index) + ",\"parts_at\":" + parts_at;
    details_.add(details.line, std::move(details.row), against_rows_);
}

/// Walks that only the other run has are listed: there is nothing to compare their details with.
void HtmlReporter::add_unmatched() {
    std::ranges::sort(seen_);
    inputs_.against->for_each([this](const WalkResult& other) {
        if (!std::ranges::binary_search(seen_, std::hash<std::string>()(other.id))) {
            against_rows_ += (against_rows_.empty() ? "" : ",\n") +
                             open_walk_row(with_paths_in_repository(inputs_.start, other), {}) +
                             ",\"index\":-1,\"parts_at\":-1,\"chunk\":-1,\"line\":0}";
        }
    });
}

void HtmlReporter::end(const ResultSequence& /*results*/) {
    details_.flush();
    if (inputs_.against) {
        add_unmatched();
    }
    std::string campuses;
    for (const std::string& entry : campus_entries_) {
        campuses += (campuses.empty() ? "" : ",\n") + entry;
    }
    const bool complete = walks_ == planned_ && inputs_.problems.empty();
    std::string index = dumped({{"campuswalk_report", 1},
                                {"title", inputs_.title},
                                {"generator", inputs_.generator},
                                {"complete", complete},
                                {"problems", inputs_.problems},
                                {"command", inputs_.command},
                                {"replay", "campuswalk run {file}[ --project {project}]"}});
    index.pop_back();
    page_.finish(index + ",\n\"campuses\":[" + campuses + "],\n\"walks\":[" + rows_ +
                 "],\n\"against\":" + against_json() + ",\n\"findings\":" + findings_json() + "}");
}

std::string HtmlReporter::against_json() const {
    return inputs_.against
               ? "{\"name\":" + dumped(inputs_.against->name) + ",\"walks\":[" + against_rows_ + "]}"
               : "null";
}

/// Each with the index of its campus; those of campuses that no walk is on are left out.
std::string HtmlReporter::findings_json() const {
    if (inputs_.findings.empty()) {
        return "null";
    }
    Json shown = Json::array();
    for (Json& finding : Json::parse(inputs_.findings)) {
        const auto campus = names_.find(finding.at("campus").get<std::string>());
        if (campus != names_.end()) {
            finding["campus"] = campus->second;
            shown.push_back(std::move(finding));
        }
    }
    return dumped(shown);
}

}  // namespace campuswalk::engine
