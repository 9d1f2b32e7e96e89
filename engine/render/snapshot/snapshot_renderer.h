#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/camera.h"
#include "engine/render/image/image.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/info_window.h"
#include "engine/render/overlay/map_marks.h"
#include "engine/render/overlay/minimap.h"
#include "engine/render/overlay/node_owners.h"
#include "engine/render/passes/render_settings.h"
#include "engine/render/renderer.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// How snapshots of a campus are drawn.
struct SnapshotSettings {
    RenderSettings light;  ///< before the light of a walk is applied
    RenderingBackend backend = RenderingBackend::automatic;
    double minimap_radius = 70.0;  ///< metres around the avatar: the next few buildings
    /// Resolution of its plan, pixels per metre: twice that of an image 720 high.
    double minimap_detail = 2.5;
    std::size_t max_windows = 3;  ///< pop-ups shown at once
    bool labels = true;           ///< building titles on plans
    FreeDistance free_distance;   ///< keeps the third-person camera out of walls, if set
    FreeRadius free_radius;       ///< keeps cameras from looking behind walls that they are at, if set
};

/// What a snapshot shows.
struct SnapshotRequest {
    CameraSettings camera;
    AvatarState avatar;
    AvatarProfile profile;
    bool nobody = false;                          ///< no avatar; only for OrbitView and FixedView
    const std::vector<bool>* disabled = nullptr;  ///< by object, for the walk space; null: none is
    double stride = 0.0;                          ///< phase of the gait, radians
    std::span<const OpenPopup> open_popups;       ///< oldest first
    std::span<const Eigen::Vector3d> path;        ///< walked so far, shown in TopView
    ImageOverlays overlays;
    std::span<const Eigen::Vector3d> contacts;  ///< foot points, for the overlay
    /// Of the colliders and triggers, the overlays show what overlaps this box; none: all.
    std::optional<collision::Aabb> outlined = {};
    std::string caption;  ///< in the upper left corner, if any
    bool minimap = true;  ///< in views from the avatar
};

/// The building and object that each pixel shows (see Channels), regardless of overlays.
struct IdImage {
    int width = 0;                   ///< pixels
    int height = 0;                  ///< pixels
    std::vector<std::uint32_t> ids;  ///< indices into `owners`, rows from top to bottom
    /// The same for all images of a campus. [0] is no owner: sky, avatar and unclaimed nodes.
    std::vector<PixelOwner> owners;
};

/// Draws complete snapshots of one campus: the image with windows, minimap and map marks. Owns the GL
/// context; create it when the first image is needed. Throws RenderError if rendering is impossible.
class SnapshotRenderer {
public:
    /// `campus` must outlive the renderer.
    SnapshotRenderer(const scene::Campus& campus, SnapshotSettings settings);

    Image draw(const SnapshotRequest& request);
    /// The channels and pixel owners of the same image.
    Channels draw_channels(const SnapshotRequest& request, const ChannelChoice& choice);
    IdImage draw_ids(const SnapshotRequest& request);
    /// Maps Channels::nodes to owners.
    IdImage ids_of(const Channels& channels);
    /// The whole campus from above with titles, north arrow, and a grid or a scale bar (`snapshot --camera
    /// top`).
    Image draw_plan(int width, int height, bool grid);
    Channels draw_plan_channels(int width, int height, const ChannelChoice& choice);
    /// Without overlays.
    Image draw_view(Viewpoint view, int width, int height);

    const scene::Bounds& bounds() const { return renderer_.bounds(); }

private:
    Viewpoint viewpoint(const SnapshotRequest& request) const;
    /// Of each kind of view, in the .cpp; one without doesn't compile.
    template <typename Kind>
    Viewpoint viewpoint_of(const Kind& view, const SnapshotRequest& request) const = delete;
    Eigen::Vector3d point_of(const CameraTarget& target) const;
    static std::optional<Figure> figure(const SnapshotRequest& request, const Viewpoint& view);
    Image draw_overlays(const Image& image, const SnapshotRequest& request, const Viewpoint& view);
    std::vector<InfoWindow> windows(const SnapshotRequest& request, const Viewpoint& view) const;
    std::optional<Eigen::Vector2d> anchor(std::size_t building, const SnapshotRequest& request,
                                          const Viewpoint& view) const;
    std::vector<MapLabel> labels() const;
    std::string title_of(std::size_t building) const;
    std::vector<OverlayLine> lines_of(const SnapshotRequest& request) const;
    std::vector<PixelLabel> visible_labels(const SnapshotRequest& request);
    const Minimap& minimap();

    const scene::Campus& campus_;
    SnapshotSettings settings_;
    Fonts fonts_;
    Renderer renderer_;
    std::vector<scene::Bounds> building_bounds_;  // one per building; empty where nothing tells where it is
    std::optional<Minimap> minimap_;
    std::optional<NodeOwners> node_owners_;  // created on first use
};

}  // namespace campuswalk::engine::render
