#include "tools/campuswalk/run/html/campus_bundle.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/html_report/campus_entry.h"
#include "engine/html_report/encodings.h"
#include "engine/html_report/foreign_json.h"
#include "scene/base/atomic_file.h"
#include "scene/base/binary_archive.h"
#include "scene/base/printable.h"
#include "scene/cache/content_hash.h"
#include "scene/cache/file_hash.h"
#include "scene/campus/node_selection.h"
#include "scene/export/write_glb.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_below.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/run/output/output_folder.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kKind = "glb";
constexpr int kEffort = 6;  // of gzip
constexpr scene::FileKind kGlbFile = {{'c', 'w', ' ', 'g', 'l', 'b'}, 2};

using TagsByNode = std::vector<std::vector<scene::Tags>>;  ///< by model and node

TagsByNode objects_of_nodes(const scene::Campus& campus) {
    TagsByNode tags;
    for (const scene::Model& model : campus.models) {
        tags.emplace_back(model.nodes.size());
    }
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        for (const scene::NodeRef& ref : scene::nodes_of(campus.models, campus.objects[i].nodes)) {
            scene::Tags& own = tags[ref.model][ref.node];
            if (own.empty() || own.back() != i) {
                own.push_back(static_cast<std::uint32_t>(i));
            }
        }
    }
    return tags;
}

/// Hashes everything that the file depends on; none if the models' contents aren't known.
std::optional<scene::ContentHash> key_of(const scene::Campus& campus, const scene::GlbSettings& settings,
                                         const TagsByNode& tags, const scene::CacheFolder& cache) {
    if (campus.contents.empty()) {
        return std::nullopt;
    }
    scene::ContentHasher hasher;
    hasher.add_hash(scene::program_hash(&cache));
    hasher.add_number(settings.error);
    hasher.add_number(static_cast<std::uint64_t>(settings.texture_size));
    for (const double along : campus.origin.at) {
        hasher.add_number(along);
    }
    for (const scene::ContentHash& contents : campus.contents) {
        hasher.add_hash(contents);
    }
    for (const std::vector<scene::Tags>& model : tags) {
        for (const scene::Tags& node : model) {
            hasher.add_number(std::uint64_t{node.size()});
            hasher.add(std::as_bytes(std::span(node)));
        }
    }
    return hasher.result();
}

std::optional<std::string> find_packed_glb(const scene::CacheFolder& cache, const scene::ContentHash& key) {
    const auto file = cache.find(key, kKind);
    if (file == nullptr) {
        return std::nullopt;
    }
    try {
        scene::ArchiveReader reader(file->bytes(), kGlbFile);
        std::string packed = reader.take_text();
        reader.finish();
        return packed;
    } catch (const scene::DamagedFile&) {
        return std::nullopt;  // it is written again
    }
}

/// The campus' models as reports show them (scene/export/write_glb.h), each node tagged with the objects that
/// it belongs to, packed by gzip. `error` in metres; 0: exact. Writing it takes as long as playing hundreds
/// of walks, so it is read from the cache of models if it was written before.
std::string packed_glb(const scene::Campus& campus, double error) {
    scene::GlbSettings settings;
    settings.error = error;
    const TagsByNode tags = objects_of_nodes(campus);
    const scene::CacheFolder* cache = model_cache();
    const std::optional<scene::ContentHash> key =
        cache != nullptr ? key_of(campus, settings, tags, *cache) : std::nullopt;
    if (key) {
        if (std::optional<std::string> known = find_packed_glb(*cache, *key)) {
            return std::move(*known);
        }
    }
    const scene::GlbFile glb = scene::write_glb(
        campus.models, settings, [&](std::size_t model, std::size_t node) { return tags[model][node]; });
    std::string packed(engine::Gzip(kEffort).pack(glb.bytes));
    if (key) {
        scene::ArchiveWriter archive(kGlbFile);
        archive.put_text(packed);
        cache->store(*key, kKind, archive.finish());
    }
    return packed;
}

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
