#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/render/sequence/animated_gif.h"
#include "engine/render/sequence/animated_png.h"
#include "engine/render/sequence/contact_sheet.h"
#include "engine/render/sequence/frame_files.h"
#include "engine/render/sequence/sequence_observer.h"
#include "tools/campuswalk/ffmpeg_video.h"
#include "tools/campuswalk/pictures.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;

namespace {

constexpr double kUsualInterval = 0.5;  // simulated seconds

engine::CameraSettings camera_for(const engine::Walk& walk, const SequenceWish& wish) {
    engine::CameraSettings camera = walk.camera;
    camera.view = wish.view.value_or(camera.view);
    if (wish.width) {
        camera.height = std::max(1, static_cast<int>(std::lround(static_cast<double>(*wish.width) *
                                                                 camera.height / camera.width)));
        camera.width = *wish.width;
    }
    return camera;
}

std::unique_ptr<render::FrameSink> animation(const std::string& name, const fs::path& folder, double every) {
    for (const AnimationKind& kind : animation_kinds()) {
        if (name == kind.name && name == "gif") {
            return std::make_unique<render::AnimatedGif>(folder / kind.file, every);
        }
        if (name == kind.name) {
            return std::make_unique<render::AnimatedPng>(folder / kind.file, every);
        }
    }
    return nullptr;
}

}  // namespace

std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus& campus, const engine::Walk& walk,
                                                      const fs::path& folder, const SequenceWish& wish,
                                                      render::PainterStore& painters) {
    render::SequenceSettings settings;
    settings.every = wish.every.value_or(kUsualInterval);
    settings.camera = camera_for(walk, wish);
    std::vector<std::unique_ptr<render::FrameSink>> sinks;
    if (wish.every) {
        sinks.push_back(std::make_unique<render::FrameFiles>(folder / kFramesFolder));
    }
    if (wish.contact_sheet) {
        sinks.push_back(std::make_unique<render::ContactSheet>(folder / kContactSheetFile));
    }
    for (const std::string& name : wish.animations) {
        sinks.push_back(animation(name, folder, settings.every));
    }
    if (wish.video) {
        sinks.push_back(std::make_unique<FfmpegVideo>(folder / kVideoFile, settings.every));
    }
    return std::make_unique<render::SequenceObserver>(campus, std::move(settings), painters,
                                                      std::move(sinks));
}

bool can_make_videos() {
    return has_ffmpeg();
}

}  // namespace campuswalk::tools
