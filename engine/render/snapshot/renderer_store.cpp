#include "engine/render/snapshot/renderer_store.h"

#include <algorithm>

#include "engine/render/passes/light.h"

namespace campuswalk::engine::render {

SnapshotPainter& PainterStore::of(const scene::Campus& campus, const LightSettings& light) {
    constexpr std::size_t kMost = 4;
    const auto found = std::ranges::find_if(
        kept_, [&](const Kept& kept) { return kept.campus == &campus && kept.light == light; });
    if (found != kept_.end()) {
        return *found->painter;
    }
    if (kept_.size() >= kMost) {
        kept_.clear();
    }
    SnapshotSettings settings = settings_of_(campus);
    settings.light = lit(settings.light, light);
    kept_.push_back({&campus, light, std::make_unique<SnapshotPainter>(campus, std::move(settings))});
    return *kept_.back().painter;
}

}  // namespace campuswalk::engine::render
