#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/light.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// A cache of renderers by campus and light, shared by images and walks: creating one takes longer than
/// drawing an image. At most a few are kept.
class RendererStore {
public:
    /// The settings of a campus under default light.
    using SettingsOf = std::function<SnapshotSettings(const scene::Campus&)>;

    explicit RendererStore(SettingsOf settings_of) : settings_of_(std::move(settings_of)) {}

    /// Valid until the next call. `campus` must outlive the store. Throws RenderError if rendering is
    /// impossible.
    SnapshotRenderer& of(const scene::Campus& campus, const LightSettings& light);

private:
    struct Entry {
        const scene::Campus* campus = nullptr;
        LightSettings light;
        std::unique_ptr<SnapshotRenderer> renderer;
    };

    SettingsOf settings_of_;
    std::vector<Entry> entries_;
};

}  // namespace campuswalk::engine::render
