#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/expect/failure.h"
#include "engine/record/observer.h"
#include "engine/render/snapshot/visibility_report.h"
#include "engine/report/walk_result.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_request.h"

namespace campuswalk::engine::render {
class RendererStore;
}

namespace campuswalk::tools {

// What the program asks of rendering. A build without it (CAMPUSWALK_RENDER=OFF) answers no to the first
// and never calls the others.

bool can_draw();

struct SnapshotTaker {
    std::unique_ptr<engine::Observer> observer;
    /// What is visible in those snapshots that an ExpectVisible refers to; lives as long as the observer.
    const engine::render::VisibleBuildingsBySnapshot* visible_buildings = nullptr;
};

/// What draws the images of the walks that a process plays. Opens nothing before the first image.
std::shared_ptr<engine::render::RendererStore> make_renderers(Backend backend);

/// Writes the walk's snapshots to `FOLDER/`. `campus` and `painters` must outlive it.
SnapshotTaker make_snapshot_taker(const scene::Campus& campus, const std::filesystem::path& folder,
                                  engine::render::RendererStore& renderers);

/// The names of a snapshot's files in its folder: `NAME.png`, then those of its channels.
std::vector<std::string> files_of(const engine::SnapshotStep& step);

// Files of a sequence, in the walk's folder.
inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kContactSheetFile = "contact-sheet.png";
inline constexpr const char* kVideoFile = "video.mp4";

/// A walk's frames drawn by several processes in turn, all of which play it.
struct SequenceSharing {
    std::size_t parts = 1;
    /// The next frame of a part other than 0, as that part handed it over; waits for it. Throws
    /// std::runtime_error when it will never come.
    std::function<std::string(std::size_t part)> take;
};

/// Takes the images that are wished for, of them part 0 by itself, and writes what is to be made of them to
/// `FOLDER/`. `campus` and `painters` must outlive it.
std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus& campus, const engine::Walk& walk,
                                                      const std::filesystem::path& folder,
                                                      const SequenceRequest& request, SequenceSharing sharing,
                                                      engine::render::RendererStore& renderers);

/// Takes those of one part, and hands them over, on a thread of its own.
std::unique_ptr<engine::Observer> make_sequence_helper(const scene::Campus& campus, const engine::Walk& walk,
                                                       const SequenceRequest& request, std::size_t part,
                                                       std::size_t parts,
                                                       std::function<void(std::string_view frame)> hand_over,
                                                       engine::render::RendererStore& renderers);

/// So many processes, of which this is one, are about to draw at the same time; to be said before the first
/// image.
void share_processors(std::size_t processes);

/// Whether a video can be made: it takes a program of others.
bool can_make_videos();

/// Draws the moments of a walk's failures, each from the avatar's eyes and from above with the way walked so
/// far: `failure[-N]-eyes.png` and `failure[-N]-above.png` in OUTPUT/FOLDER, N counting from the second
/// moment on. Failures of one tick share their images, and later ones than the fourth moment get none. The
/// walk is played again up to there. Returns what was written, paths relative to `output`. `campus` must
/// outlive `painters`. Throws std::runtime_error when it can't be drawn or written.
std::vector<engine::Artifact> draw_failures(const scene::Campus& campus, const engine::Walk& walk,
                                            std::span<const engine::Failure> failures,
                                            const std::filesystem::path& output,
                                            const std::filesystem::path& folder,
                                            engine::render::RendererStore& renderers);

/// The end of a way from above, with the way; the avatar looks where it leads. `way` has at least one point.
void draw_way(const scene::Campus& campus, const engine::AvatarProfile& avatar,
              std::span<const Eigen::Vector3d> way, const std::string& caption,
              const std::filesystem::path& file, Backend backend);

/// An image of a campus that nobody walks in.
struct CampusImage {
    bool plan = false;              ///< from above, all of it; of `camera` only the size counts
    engine::CameraSettings camera;  ///< FirstPersonView from `avatar`'s place, or one that needs nobody
    engine::AvatarState avatar;
    engine::LightSettings light;
    engine::ImageChannels channels;  ///< go beside `file`
    engine::ImageOverlays overlays;  ///< not on a plan
    std::filesystem::path file;
    Backend backend = engine::render::RenderingBackend::automatic;
};
void draw_campus(const scene::Campus& campus, const CampusImage& image);

}  // namespace campuswalk::tools
