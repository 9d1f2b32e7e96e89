#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include "engine/events/decimals.h"
#include "engine/render/gl/driver_threads.h"
#include "engine/render/sequence/animated_gif.h"
#include "engine/render/sequence/animated_png.h"
#include "engine/render/sequence/contact_sheet.h"
#include "engine/render/sequence/frame_bytes.h"
#include "engine/render/sequence/frame_files.h"
#include "engine/render/sequence/frame_sharing.h"
#include "engine/render/sequence/frame_sink.h"
#include "engine/render/sequence/sequence_observer.h"
#include "scene/base/atomic_file.h"
#include "scene/process/child_process.h"
#include "scene/process/pipe.h"
#include "tools/campuswalk/base/environment.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;

namespace {

/// ffmpeg's arguments. H.264 stores colours at half the resolution, so an odd width or height loses its last
/// pixel.
std::vector<std::string> arguments(const engine::render::Image& image, double seconds_per_frame,
                                   const fs::path& file) {
    return {"-hide_banner",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgba",
            "-video_size",
            std::to_string(image.width) + "x" + std::to_string(image.height),
            "-framerate",
            engine::fixed(1.0 / seconds_per_frame, 6),
            "-i",
            "pipe:0",
            "-an",
            "-vf",
            "crop=trunc(iw/2)*2:trunc(ih/2)*2",
            "-c:v",
            "libx264",
            "-pix_fmt",
            "yuv420p",
            "-f",
            "mp4",
            fs::absolute(file).string()};
}

/// Writes frames as H.264 in MP4 with the program ffmpeg, which gets their bytes through a pipe.
class FfmpegVideo final : public engine::render::FrameSink {
public:
    /// `seconds_per_frame` is how long a frame is shown.
    FfmpegVideo(fs::path file, double seconds_per_frame)
        : file_(std::move(file)), seconds_per_frame_(seconds_per_frame) {}

    /// Ends ffmpeg, and leaves no half-written file.
    ~FfmpegVideo() override {
        if (process_.running()) {
            wait_for_end();
        }
    }
    FfmpegVideo(const FfmpegVideo&) = delete;
    FfmpegVideo& operator=(const FfmpegVideo&) = delete;

    void add(const engine::render::Frame& frame) override {
        if (!process_.running()) {
            start(frame.image);
        }
        if (!scene::write_all(pipe_.number(), std::as_bytes(std::span(frame.image.rgba)))) {
            wait_for_end();
            fail("ffmpeg ended before the walk did; see its output");
        }
    }

    void finish() override {
        if (!process_.running()) {
            return;
        }
        if (!wait_for_end()) {
            fail("ffmpeg failed; see its output");
        }
        written_->finish();
    }

private:
    void start(const engine::render::Image& image) {
        written_ = std::make_unique<scene::AtomicFile>(file_);
        try {
            scene::Pipe pipe = scene::make_pipe();
            process_ = scene::start_program(
                {.program = "ffmpeg",
                 .arguments = arguments(image, seconds_per_frame_, written_->temporary()),
                 .environment = {},
                 .input = pipe.reading.number(),
                 .output = STDERR_FILENO});
            pipe_ = std::move(pipe.writing);
        } catch (const std::system_error& error) {
            fail("ffmpeg can't be started: " + error.code().message());
        }
    }

    /// Closes the pipe and waits for ffmpeg. Returns whether it succeeded.
    bool wait_for_end() {
        pipe_.close();
        return process_.wait().success();
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw std::runtime_error("can't write " + file_.string() + ": " + why);
    }

    fs::path file_;
    std::unique_ptr<scene::AtomicFile> written_;  ///< by ffmpeg
    double seconds_per_frame_;
    scene::ChildProcess process_;
    scene::Descriptor pipe_;
};

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
    std::istringstream folders(environment_variable("PATH").value_or(""));
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

}  // namespace campuswalk::tools
