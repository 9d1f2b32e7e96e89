#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/light.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Painters, one a campus and light, kept for the images and walks that follow: making one takes longer
/// than its images. A process that plays many campuses keeps a few.
class RendererStore {
public:
    /// How a campus is drawn by day.
    using SettingsOf = std::function<SnapshotSettings(const scene::Campus&)>;

    explicit RendererStore(SettingsOf settings_of) : settings_of_(std::move(settings_of)) {}

    /// Good until the next call. `campus` must outlive the store. Throws RenderError when the machine can't
    /// draw.
    SnapshotRenderer& of(const scene::Campus& campus, const LightSettings& light);

private:
    struct CachedPiece {
        const scene::Campus* campus = nullptr;
        LightSettings light;
        std::unique_ptr<SnapshotRenderer> snapshot_renderer;
    };

    SettingsOf settings_of_;
    std::vector<CachedPiece> cached_;
};

}  // namespace campuswalk::engine::render
