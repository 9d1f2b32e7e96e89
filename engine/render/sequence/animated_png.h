#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/render/image/png_file.h"
#include "engine/render/sequence/frame_sink.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::engine::render {

/// Widest that animations are: wider frames are made smaller.
constexpr int kAnimationWidth = 640;  // pixels

/// An animation in PNG (https://www.w3.org/TR/png-3/, chunks acTL, fcTL and fdAT), played for ever. Programs
/// that know no animations show its first frame. Frames go to disk as they come.
class AnimatedPng final : public FrameSink {
public:
    /// A frame is shown for so many seconds, 1/1000 at least.
    AnimatedPng(std::filesystem::path file, double seconds_per_frame);
    void add(const Frame& frame) override;
    /// Puts it where it belongs unless there was no frame. Without this there is no file.
    void finish() override;

private:
    void put_count(std::uint32_t frames);
    void put_control(const Image& image);

    std::filesystem::path file_;
    std::uint16_t milliseconds_;
    PixelCompressor compressor_;
    std::unique_ptr<PngWriter> png_;  ///< what is still to be written
    std::unique_ptr<scene::AtomicFile> written_;
    std::size_t count_at_ = 0;  ///< where the chunk is that holds the count of frames
    std::uint32_t frames_ = 0;
    std::uint32_t sequence_ = 0;  ///< numbers the chunks of frames
};

}  // namespace campuswalk::engine::render
