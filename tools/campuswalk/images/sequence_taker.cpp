#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/render/gl/driver_threads.h"
#include "engine/render/sequence/animated_gif.h"
#include "engine/render/sequence/animated_png.h"
#include "engine/render/sequence/contact_sheet.h"
#include "engine/render/sequence/frame_bytes.h"
#include "engine/render/sequence/frame_files.h"
#include "engine/render/sequence/frame_sharing.h"
#include "engine/render/sequence/sequence_observer.h"
#include "tools/campuswalk/images/ffmpeg_video.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;

namespace {

engine::CameraSettings camera_for(const engine::Walk& walk, const SequenceRequest& request) {
    engine::CameraSettings camera = walk.camera;
    if (request.view) {
        camera.view = walk.views[request.view->index()];
    }
    if (request.width) {
        camera.height = std::max(1, static_cast<int>(std::lround(static_cast<double>(*request.width) *
                                                                 camera.height / camera.width)));
        camera.width = *request.width;
    }
    return camera;
}

std::unique_ptr<render::FrameSink> animation(const std::string& name, const fs::path& folder, double every) {
    for (const AnimationKind& kind : kAnimationKinds) {
        if (name == kind.name && name == "gif") {
            return std::make_unique<render::AnimatedGif>(folder / kind.file, every);
        }
        if (name == kind.name) {
            return std::make_unique<render::AnimatedPng>(folder / kind.file, every);
        }
    }
    return nullptr;
}

render::SequenceSettings settings_of(const engine::Walk& walk, const SequenceRequest& request,
                                     const render::SequenceShare& share) {
    render::SequenceSettings settings;
    settings.every = interval_of(request);
    settings.camera = camera_for(walk, request);
    settings.share = share;
    return settings;
}

std::vector<std::unique_ptr<render::FrameSink>> sinks_of(const SequenceRequest& request,
                                                         const fs::path& folder) {
    const double every = interval_of(request);
    std::vector<std::unique_ptr<render::FrameSink>> sinks;
    if (request.every) {
        sinks.push_back(std::make_unique<render::FrameFiles>(folder / kFramesFolder));
    }
    if (request.contact_sheet) {
        sinks.push_back(std::make_unique<render::ContactSheet>(folder / kContactSheetFile));
    }
    for (const std::string& name : request.animations) {
        sinks.push_back(animation(name, folder, every));
    }
    if (request.video) {
        sinks.push_back(std::make_unique<FfmpegVideo>(folder / kVideoFile, every));
    }
    return sinks;
}

/// The frames of the other parts, as these hand them over.
class HelperFrames final : public render::FrameSource {
public:
    explicit HelperFrames(SequenceSharing sharing) : sharing_(std::move(sharing)) {}

    render::Frame take(std::size_t number) override {
        render::Frame frame = render::deserialize_frame(sharing_.take(number % sharing_.parts));
        if (frame.number != number) {
            throw std::runtime_error("processes that draw the same walk's frames don't agree on them");
        }
        return frame;
    }

private:
    SequenceSharing sharing_;
};

class FrameSender final : public render::FrameSink {
public:
    explicit FrameSender(std::function<void(std::string_view)> hand_over)
        : hand_over_(std::move(hand_over)) {}
    void add(const render::Frame& frame) override { hand_over_(render::serialize(frame)); }
    void finish() override {}

private:
    std::function<void(std::string_view)> hand_over_;
};

}  // namespace

std::unique_ptr<engine::Observer> make_sequence_taker(const scene::Campus& campus, const engine::Walk& walk,
                                                      const fs::path& folder, const SequenceRequest& request,
                                                      SequenceSharing sharing,
                                                      render::RendererStore& renderers) {
    const std::size_t parts = sharing.parts;  // before it is moved from: arguments have no order
    return std::make_unique<render::SequenceObserver>(campus, settings_of(walk, request, {0, parts}),
                                                      renderers, sinks_of(request, folder),
                                                      std::make_unique<HelperFrames>(std::move(sharing)));
}

std::unique_ptr<engine::Observer> make_sequence_helper(const scene::Campus& campus, const engine::Walk& walk,
                                                       const SequenceRequest& request, std::size_t part,
                                                       std::size_t parts,
                                                       std::function<void(std::string_view)> hand_over,
                                                       render::RendererStore& renderers) {
    std::vector<std::unique_ptr<render::FrameSink>> sinks;
    sinks.push_back(std::make_unique<FrameSender>(std::move(hand_over)));
    return std::make_unique<render::SequenceObserver>(campus, settings_of(walk, request, {part, parts}),
                                                      renderers, std::move(sinks));
}

void share_processors(std::size_t processes) {
    render::share_processors(processes);
}

bool can_make_videos() {
    return has_ffmpeg();
}

}  // namespace campuswalk::tools
