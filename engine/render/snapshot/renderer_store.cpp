#include "engine/render/snapshot/renderer_store.h"

#include <algorithm>

#include "engine/render/passes/light.h"

namespace campuswalk::engine::render {

SnapshotRenderer& RendererStore::of(const scene::Campus& campus, const LightSettings& light) {
    constexpr std::size_t kMost = 4;
    const auto found = std::ranges::find_if(
        cached_, [&](const CachedPiece& kept) { return kept.campus == &campus && kept.light == light; });
    if (found != cached_.end()) {
        return *found->snapshot_renderer;
    }
    if (cached_.size() >= kMost) {
        cached_.clear();
    }
    SnapshotSettings settings = settings_of_(campus);
    settings.light = apply_light(settings.light, light);
    cached_.push_back({&campus, light, std::make_unique<SnapshotRenderer>(campus, std::move(settings))});
    return *cached_.back().snapshot_renderer;
}

}  // namespace campuswalk::engine::render
