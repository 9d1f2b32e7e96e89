#include <cassert>

#include "tools/campuswalk/picture_verdicts.h"
#include "tools/campuswalk/pictures.h"

namespace campuswalk::tools {

bool can_draw() {
    return false;
}

std::unique_ptr<SnapshotTaker> make_snapshot_taker(const scene::Campus&, const std::filesystem::path&,
                                                   Backend) {
    assert(false);
    return nullptr;
}

std::vector<std::string> files_of(const engine::SnapshotStep&) {
    assert(false);
    return {};
}

class FailurePictures::Painters {};
FailurePictures::FailurePictures() = default;
FailurePictures::~FailurePictures() = default;

std::vector<engine::Artifact> FailurePictures::draw(const scene::Campus&, const engine::Walk&,
                                                    std::span<const engine::Failure>,
                                                    const std::filesystem::path&,
                                                    const std::filesystem::path&, Backend) {
    assert(false);
    return {};
}

std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus&, const engine::Walk&,
                                                      const std::filesystem::path&, const SequenceWish&,
                                                      Backend) {
    assert(false);
    return nullptr;
}

bool can_make_videos() {
    return false;
}

JudgedPictures judge_pictures(const PictureTrial&) {
    assert(false);
    return {};
}

void draw_way(const scene::Campus&, const engine::AvatarProfile&, std::span<const Eigen::Vector3d>,
              const std::string&, const std::filesystem::path&, Backend) {
    assert(false);
}

void draw_campus(const scene::Campus&, const CampusPicture&) {
    assert(false);
}

}  // namespace campuswalk::tools
