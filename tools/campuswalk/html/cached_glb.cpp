#include "tools/campuswalk/html/cached_glb.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/cache/content_hash.h"
#include "scene/cache/file_hash.h"
#include "scene/campus/node_selection.h"
#include "scene/export/write_glb.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

namespace {

constexpr const char* kKind = "glb";
constexpr scene::FileKind kGlbFile = {{'c', 'w', ' ', 'g', 'l', 'b'}, 1};

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

std::optional<std::string> find_glb(const scene::CacheFolder& cache, const scene::ContentHash& key) {
    const auto file = cache.find(key, kKind);
    if (file == nullptr) {
        return std::nullopt;
    }
    try {
        scene::ArchiveReader reader(file->bytes(), kGlbFile);
        std::string glb = reader.take_text();
        reader.finish();
        return glb;
    } catch (const scene::DamagedFile&) {
        return std::nullopt;  // it is written again
    }
}

}  // namespace

std::string cached_glb(const scene::Campus& campus, double error) {
    scene::GlbSettings settings;
    settings.error = error;
    const TagsByNode tags = objects_of_nodes(campus);
    const scene::CacheFolder* cache = model_cache();
    const std::optional<scene::ContentHash> key =
        cache != nullptr ? key_of(campus, settings, tags, *cache) : std::nullopt;
    if (key) {
        if (std::optional<std::string> known = find_glb(*cache, *key)) {
            return std::move(*known);
        }
    }
    std::string glb = scene::write_glb(campus.models, settings, [&](std::size_t model, std::size_t node) {
                          return tags[model][node];
                      }).bytes;
    if (key) {
        scene::ArchiveWriter archive(kGlbFile);
        archive.put_text(glb);
        cache->store(*key, kKind, archive.finish());
    }
    return glb;
}

}  // namespace campuswalk::tools
