#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "engine/render/sequence/frame_sink.h"
#include "scene/base/atomic_file.h"
#include "scene/process/child_process.h"
#include "scene/process/pipe.h"

namespace campuswalk::tools {

/// Whether there is a program `ffmpeg` in PATH.
bool has_ffmpeg();

/// Writes frames as H.264 in MP4 with the program ffmpeg, which gets their bytes through a pipe.
class FfmpegVideo final : public engine::render::FrameSink {
public:
    /// `seconds_per_frame` is how long a frame is shown.
    FfmpegVideo(std::filesystem::path file, double seconds_per_frame);
    /// Ends ffmpeg, and leaves no half-written file.
    ~FfmpegVideo() override;
    FfmpegVideo(const FfmpegVideo&) = delete;
    FfmpegVideo& operator=(const FfmpegVideo&) = delete;

    void add(const engine::render::Frame& frame) override;
    void finish() override;

private:
    void start(const engine::render::Image& image);
    /// Closes the pipe and waits for ffmpeg. Returns whether it succeeded.
    bool wait_for_end();
    [[noreturn]] void fail(const std::string& why) const;

    std::filesystem::path file_;
    std::unique_ptr<scene::AtomicFile> written_;  ///< by ffmpeg
    double seconds_per_frame_;
    scene::ChildProcess process_;
    scene::Descriptor pipe_;
};

}  // namespace campuswalk::tools
