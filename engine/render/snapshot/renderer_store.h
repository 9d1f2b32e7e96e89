#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/light.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Painters, one a campus and light, kept for the pictures and walks that follow: making one takes longer
/// than its pictures. A process that plays many campuses keeps a few.
class PainterStore {
public:
    /// How a campus is drawn by day.
    using SettingsOf = std::function<SnapshotSettings(const scene::Campus&)>;

    explicit PainterStore(SettingsOf settings_of) : settings_of_(std::move(settings_of)) {}

    /// Good until the next call. `campus` must outlive the store. Throws RenderError when the machine can't
    /// draw.
    SnapshotPainter& of(const scene::Campus& campus, const LightSettings& light);

private:
    struct Kept {
        const scene::Campus* campus = nullptr;
        LightSettings light;
        std::unique_ptr<SnapshotPainter> painter;
    };

    SettingsOf settings_of_;
    std::vector<Kept> kept_;
};

}  // namespace campuswalk::engine::render
