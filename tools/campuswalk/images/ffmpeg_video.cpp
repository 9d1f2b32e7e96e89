#include "tools/campuswalk/images/ffmpeg_video.h"

#include <unistd.h>

#include <span>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "tools/campuswalk/base/environment.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

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

}  // namespace

bool has_ffmpeg() {
    std::istringstream folders(environment_variable("PATH").value_or(""));
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

FfmpegVideo::FfmpegVideo(fs::path file, double seconds_per_frame)
    : file_(std::move(file)), seconds_per_frame_(seconds_per_frame) {}

FfmpegVideo::~FfmpegVideo() {
    if (process_.running()) {
        wait_for_end();
    }
}

void FfmpegVideo::start(const engine::render::Image& image) {
    written_ = std::make_unique<scene::AtomicFile>(file_);
    try {
        scene::Pipe pipe = scene::make_pipe();
        process_ =
            scene::start_program({.program = "ffmpeg",
                                  .arguments = arguments(image, seconds_per_frame_, written_->temporary()),
                                  .environment = {},
                                  .input = pipe.reading.number(),
                                  .output = STDERR_FILENO});
        pipe_ = std::move(pipe.writing);
    } catch (const std::system_error& error) {
        fail("ffmpeg can't be started: " + error.code().message());
    }
}

void FfmpegVideo::add(const engine::render::Frame& frame) {
    if (!process_.running()) {
        start(frame.image);
    }
    if (!scene::write_all(pipe_.number(), std::as_bytes(std::span(frame.image.rgba)))) {
        wait_for_end();
        fail("ffmpeg ended before the walk did; see its output");
    }
}

void FfmpegVideo::finish() {
    if (!process_.running()) {
        return;
    }
    if (!wait_for_end()) {
        fail("ffmpeg failed; see its output");
    }
    written_->finish();
}

bool FfmpegVideo::wait_for_end() {
    pipe_.close();
    return process_.wait().success();
}

void FfmpegVideo::fail(const std::string& why) const {
    throw std::runtime_error("can't write " + file_.string() + ": " + why);
}

}  // namespace campuswalk::tools
