#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "engine/record/observer.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/visibility_report.h"
#include "engine/render/snapshot/walk_snapshots.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Writes `FOLDER/SNAPSHOT NAME.png` with the open pop-ups for every snapshot step, and its channels beside
/// it. A walk without snapshots loads no GL library and creates no folder.
class SnapshotObserver final : public Observer {
public:
    /// `campus` and `renderers` must outlive the observer.
    SnapshotObserver(const scene::Campus& campus, std::filesystem::path folder, RendererStore& renderers)
        : campus_(campus), folder_(std::move(folder)), renderers_(renderers) {}

    void begin(const Walk& walk) override;
    /// Throws RenderError if rendering is impossible, std::runtime_error that names a file that can't be
    /// written.
    void on_tick(const TickRecord& record) override;

    /// The images written since construction, in order.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// Visible buildings of the snapshots that an ExpectVisible refers to.
    const VisibleBuildingsBySnapshot& visible_buildings() const { return visible_buildings_; }

private:
    void take(const SnapshotStep& step, const TickRecord& record);
    VisibleBuildings visible_buildings_of(SnapshotRenderer& renderer, const SnapshotRequest& request) const;

    const scene::Campus& campus_;
    std::filesystem::path folder_;
    RendererStore& renderers_;
    SnapshotRequestBuilder requests_;
    std::vector<Eigen::Vector3d> contacts_;  // foot points at collisions
    std::vector<std::filesystem::path> files_;
    VisibleBuildingsBySnapshot visible_buildings_;  ///< empty until the snapshot is drawn
};

}  // namespace campuswalk::engine::render
