#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "engine/expect/failure.h"
#include "engine/record/observer.h"
#include "engine/render/snapshot/visibility_report.h"
#include "engine/report/walk_result.h"
#include "engine/script/walk.h"
#include "engine/simulation/route_memory.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_request.h"

namespace campuswalk::engine::render {
class RendererStore;
struct StoreyPlan;
}  // namespace campuswalk::engine::render

namespace campuswalk::tools {

// What the program needs of rendering. In a build without it (CAMPUSWALK_RENDER=OFF) can_draw() and
// can_make_videos() return false, files_of() names no files, and the functions that draw are never called.

bool can_draw();

struct SnapshotTaker {
    std::unique_ptr<engine::Observer> observer;
    /// What is visible in those snapshots that an ExpectVisible refers to; lives as long as the observer.
    const engine::render::VisibleBuildingsBySnapshot* visible_buildings = nullptr;
};

/// The renderers of the walks that a process plays. Opens nothing before the first image.
std::shared_ptr<engine::render::RendererStore> make_renderers(Backend backend);

/// Writes the walk's snapshots to `FOLDER/`. `campus` and `renderers` must outlive it.
SnapshotTaker make_snapshot_taker(const scene::Campus& campus, const std::filesystem::path& folder,
                                  engine::render::RendererStore& renderers);

/// The names of a snapshot's files in its folder: `NAME.png`, then those of its channels.
std::vector<std::string> files_of(const std::string& name, const engine::ImageChannels& channels);

// The files of a sequence, in the walk's folder.
inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kContactSheetFile = "contact-sheet.png";
inline constexpr const char* kVideoFile = "video.mp4";

/// How several processes, all of which play the same walk, take turns drawing its frames.
struct SequenceSharing {
    std::size_t parts = 1;
    /// Waits for the next frame of a part other than 0 and returns it as that part handed it over. Throws
    /// std::runtime_error when there won't be one.
    std::function<std::string(std::size_t part)> take;
};

/// Collects the requested frames, of which it draws part 0, and writes what is to be made of them to
/// `FOLDER/`. `campus` and `renderers` must outlive it.
std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus& campus, const engine::Walk& walk,
                                                      const std::filesystem::path& folder,
                                                      const SequenceRequest& request, SequenceSharing sharing,
                                                      engine::render::RendererStore& renderers);

/// Draws the frames of one part and hands them over, on a thread of its own.
std::unique_ptr<engine::Observer> make_sequence_helper(const scene::Campus& campus, const engine::Walk& walk,
                                                       const SequenceRequest& request, std::size_t part,
                                                       std::size_t parts,
                                                       std::function<void(std::string_view frame)> hand_over,
                                                       engine::render::RendererStore& renderers);

/// Announces that `processes`, of which this is one, are going to draw at the same time. To be called before
/// the first image.
void share_processors(std::size_t processes);

/// Whether a video can be made: that needs ffmpeg.
bool can_make_videos();

/// Draws the moments of a walk's failures, each from the avatar's eyes, from beside with what is in its way
/// in the middle, and from above with the path walked so far: `failure[-N]-eyes.png`, `-beside.png` and
/// `-above.png` in OUTPUT/FOLDER, N counting from the second moment on. Failures of one tick share their
/// images, and those after the fourth moment get none. Plays the walk again up to the last one, with what is
/// remembered of its routes; `routes` may be null. Returns what was written, with paths relative to `output`.
/// `campus` must outlive `renderers`. Throws std::runtime_error when an image can't be drawn or written.
std::vector<engine::Artifact> draw_failures(const scene::Campus& campus, const engine::Walk& walk,
                                            std::span<const engine::Failure> failures,
                                            const std::filesystem::path& output,
                                            const std::filesystem::path& folder,
                                            engine::render::RendererStore& renderers,
                                            engine::RouteMemory* routes = nullptr);

/// Draws the end of a path from above, with the path; the avatar faces along it. `path` has at least one
/// point.
void draw_walked_path(const scene::Campus& campus, const engine::AvatarProfile& avatar,
                      std::span<const Eigen::Vector3d> path, const std::string& caption,
                      const std::filesystem::path& file, Backend backend);

/// What is drawn over a plan of a campus, metres.
struct PlanMarks {
    struct Area {
        std::array<Eigen::Vector3d, 4> vertices;
        std::string name;
    };
    std::vector<Area> areas;
    std::vector<Eigen::Vector3d> doorways;
    std::vector<Eigen::Vector3d> path;
    engine::AvatarState visitor;  ///< where the path begins
};

/// An image of a campus without a visitor.
struct CampusImage {
    bool plan = false;              ///< all of it from above; only the size of `camera` counts
    engine::CameraSettings camera;  ///< FirstPersonView from `avatar`, or a view that needs no avatar
    engine::AvatarState avatar;
    engine::LightSettings light;
    engine::ImageChannels channels;  ///< written beside `file`
    engine::ImageOverlays overlays;  ///< on a plan only its grid
    std::optional<PlanMarks> marks;  ///< on a plan, instead of the buildings' names
    std::filesystem::path file;
    Backend backend = engine::render::RenderingBackend::automatic;
};
void draw_campus(const scene::Campus& campus, const CampusImage& image);

/// Draws plans of storeys, one below the other. Needs no backend.
void draw_storey_plans(std::span<const engine::render::StoreyPlan> plans, const std::filesystem::path& file);

}  // namespace campuswalk::tools
