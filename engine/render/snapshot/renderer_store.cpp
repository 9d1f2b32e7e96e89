#include "engine/render/snapshot/renderer_store.h"

#include <algorithm>

#include "engine/render/passes/light.h"

namespace campuswalk::engine::render {

SnapshotRenderer& RendererStore::of(const scene::Campus& campus, const LightSettings& light) {
    constexpr std::size_t kMaxRenderers = 4;
    const auto found = std::ranges::find_if(
        entries_, [&](const Entry& entry) { return entry.campus == &campus && entry.light == light; });
    if (found != entries_.end()) {
        return *found->renderer;
    }
    if (entries_.size() >= kMaxRenderers) {
        entries_.clear();
    }
    SnapshotSettings settings = settings_of_(campus);
    settings.light = apply_light(settings.light, light);
    entries_.push_back({&campus, light, std::make_unique<SnapshotRenderer>(campus, std::move(settings))});
    return *entries_.back().renderer;
}

}  // namespace campuswalk::engine::render
