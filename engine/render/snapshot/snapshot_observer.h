#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "engine/record/observer.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/snapshot_sight.h"
#include "engine/render/snapshot/walk_shots.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Writes `FOLDER/SNAPSHOT NAME.png` for every snapshot step, with the pop-ups that are open then, and its
/// channels beside it.
/// A walk without snapshots opens no GL library and makes no folder.
class SnapshotObserver final : public Observer {
public:
    /// `campus` and `painters` must outlive the observer.
    SnapshotObserver(const scene::Campus& campus, std::filesystem::path folder, RendererStore& renderers)
        : campus_(campus), folder_(std::move(folder)), renderers_(renderers) {}

    void begin(const Walk& walk) override;
    /// Throws RenderError when the machine can't draw, std::runtime_error naming a file that can't be
    /// written.
    void frame(const TickRecord& record) override;

    /// The images written since construction, in order.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// What is to be seen in those that an ExpectVisible names.
    const VisibleBuildingsBySnapshot& visible_buildings() const { return visible_buildings_; }

private:
    void take(const SnapshotStep& step, const TickRecord& record);
    VisibleBuildings visible_buildings_of(SnapshotRenderer& snapshot_renderer,
                                          const SnapshotRequest& request) const;

    const scene::Campus& campus_;
    std::filesystem::path folder_;
    RendererStore& renderers_;
    SnapshotRequestBuilder requests_;
    std::vector<Eigen::Vector3d> contacts_;  // where the avatar touched something
    std::vector<std::filesystem::path> files_;
    VisibleBuildingsBySnapshot visible_buildings_;  ///< of those wanted; empty ones until they are taken
};

}  // namespace campuswalk::engine::render
