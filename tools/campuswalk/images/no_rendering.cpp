// A build without rendering (CAMPUSWALK_RENDER=OFF): these functions say so, and the others are never called.
#include <cassert>
#include <stdexcept>

#include "tools/campuswalk/images/compare_image_files.h"
#include "tools/campuswalk/images/image_verdicts.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {

bool can_draw() {
    return false;
}

bool can_make_videos() {
    return false;
}

int compare_image_files(const ImgdiffOptions&) {
    throw std::runtime_error("this build reads no pictures: configure with CAMPUSWALK_RENDER=ON");
}

std::shared_ptr<engine::render::RendererStore> make_renderers(Backend) {
    return nullptr;
}

SnapshotTaker make_snapshot_taker(const scene::Campus&, const std::filesystem::path&,
                                  engine::render::RendererStore&) {
    assert(false);
    return {};
}

/// Those that this build writes.
std::vector<std::string> files_of(const std::string&, const engine::ImageChannels&) {
    return {};
}

std::vector<engine::Artifact> draw_failures(const scene::Campus&, const engine::Walk&,
                                            std::span<const engine::Failure>, const std::filesystem::path&,
                                            const std::filesystem::path&, engine::render::RendererStore&,
                                            engine::RouteMemory*) {
    assert(false);
    return {};
}

std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus&, const engine::Walk&,
                                                      const std::filesystem::path&, const SequenceRequest&,
                                                      SequenceSharing, engine::render::RendererStore&) {
    assert(false);
    return nullptr;
}

std::unique_ptr<engine::Observer> make_sequence_helper(const scene::Campus&, const engine::Walk&,
                                                       const SequenceRequest&, std::size_t, std::size_t,
                                                       std::function<void(std::string_view)>,
                                                       engine::render::RendererStore&) {
    assert(false);
    return nullptr;
}

void share_processors(std::size_t) {}

EvaluatedImages evaluate_images(const ImageEvaluation&) {
    assert(false);
    return {};
}

void draw_walked_path(const scene::Campus&, const engine::AvatarProfile&, std::span<const Eigen::Vector3d>,
                      const std::string&, const std::filesystem::path&, Backend) {
    assert(false);
}

void draw_campus(const scene::Campus&, const CampusImage&) {
    assert(false);
}

void draw_storey_plans(std::span<const engine::render::StoreyPlan>, const std::filesystem::path&) {
    assert(false);
}

}  // namespace campuswalk::tools
