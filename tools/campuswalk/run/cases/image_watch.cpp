#include "tools/campuswalk/run/cases/image_watch.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace campuswalk::tools {

namespace {

bool expects_images(const engine::Walk& walk) {
    return std::ranges::any_of(walk.expectations, engine::is_about_images);
}

}  // namespace

bool must_fail_in_images(const engine::Walk& walk) {
    const std::vector<std::string> codes = engine::image_failure_codes();
    return walk.status.kind == engine::WalkStatus::Kind::xfail && expects_images(walk) &&
           (walk.status.codes.empty() || std::ranges::any_of(walk.status.codes, [&](const std::string& code) {
                return std::ranges::find(codes, code) != codes.end();
            }));
}

ImageWatch::ImageWatch(const Case& played, const PlaySettings& settings,
                       engine::render::RendererStore& renderers, FrameHelpers* helpers)
    : played_(played), settings_(settings) {
    const LoadedWalk& loaded = *played.walk;
    const std::filesystem::path folder = settings.output / played.folder;
    taker_ = make_snapshot_taker(*loaded.campus, folder, renderers);
    if (settings.sequence.any()) {
        SequenceSharing sharing;
        if (helpers != nullptr) {
            sharing = {helpers->parts(), [helpers](std::size_t part) { return helpers->next_frame(part); }};
        }
        sequence_ = make_sequence_taker(*loaded.campus, loaded.walk, folder, settings.sequence,
                                        std::move(sharing), renderers);
    }
}

void ImageWatch::on_tick(const engine::TickRecord& record) {
    taken_.insert(taken_.end(), record.snapshots.begin(), record.snapshots.end());
}

std::vector<engine::Observer*> ImageWatch::observers() {
    std::vector<engine::Observer*> all = {this, taker_.observer.get()};
    if (sequence_) {
        all.push_back(sequence_.get());
    }
    if (expects_images(played_.walk->walk)) {
        all.push_back(&moments_);
    }
    return all;
}

EvaluatedImages ImageWatch::evaluate() const {
    const engine::Walk& walk = played_.walk->walk;
    if (!expects_images(walk)) {
        return {};
    }
    return evaluate_images({played_.result.file, *played_.walk->campus, walk, settings_.output,
                            played_.folder, settings_.update, settings_.tolerance, moments_,
                            *taker_.visible_buildings});
}

std::vector<engine::Artifact> ImageWatch::snapshot_files() const {
    std::vector<engine::Artifact> files;
    for (const engine::SnapshotStep* step : taken_) {
        for (const std::string& file : files_of(step->name, step->channels)) {
            files.push_back({std::filesystem::path(file).stem().string(), played_.folder + "/" + file,
                             file.ends_with(".png") ? "image/png" : "application/json"});
        }
    }
    return files;
}

std::vector<engine::Artifact> ImageWatch::sequence_files() const {
    const SequenceRequest& request = settings_.sequence;
    std::vector<engine::Artifact> files;
    const auto add = [&](const std::string& name, const std::string& file, const std::string& media_type) {
        files.push_back({name, played_.folder + "/" + file, media_type});
    };
    if (request.contact_sheet) {
        add("contact sheet", kContactSheetFile, "image/png");
    }
    for (const AnimationKind& kind : kAnimationKinds) {
        if (std::ranges::find(request.animations, kind.name) != request.animations.end()) {
            add("animation", kind.file, kind.media_type);
        }
    }
    if (request.video) {
        add("video", kVideoFile, "video/mp4");
    }
    return files;
}

}  // namespace campuswalk::tools
