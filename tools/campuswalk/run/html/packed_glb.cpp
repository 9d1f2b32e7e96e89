#include "tools/campuswalk/run/html/packed_glb.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/html_report/encodings.h"
#include "scene/base/binary_archive.h"
#include "scene/cache/content_hash.h"
#include "scene/cache/file_hash.h"
#include "scene/campus/node_selection.h"
#include "scene/export/write_glb.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

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

/// Of everything that the file depends on; none if the models' contents aren't known.
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

}  // namespace

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

}  // namespace campuswalk::tools
