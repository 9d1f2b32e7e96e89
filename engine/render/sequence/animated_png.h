#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "engine/render/image/png_file.h"
#include "engine/render/sequence/frame_sink.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::engine::render {

/// Maximum width of animations; wider frames are downsampled.
constexpr int kAnimationWidth = 640;  // pixels

/// A looping animated PNG (https://www.w3.org/TR/png-3/, chunks acTL, fcTL and fdAT). Viewers without support
/// show its first frame. Frames are written as they arrive.
class AnimatedPng final : public FrameSink {
public:
    /// Frame durations are multiples of 0.001 s, at least that.
    AnimatedPng(std::filesystem::path file, double seconds_per_frame);
    void add(const Frame& frame) override;
    /// Moves the file into place; writes none without frames.
    void finish() override;

private:
    void put_count(std::uint32_t frames);
    void put_control(const Image& image);

    std::filesystem::path file_;
    std::uint16_t milliseconds_;
    PixelCompressor compressor_;
    std::unique_ptr<PngWriter> png_;  ///< bytes still to be written
    std::unique_ptr<scene::AtomicFile> written_;
    std::size_t count_at_ = 0;  ///< file offset of the chunk with the frame count
    std::uint32_t frames_ = 0;
    std::uint32_t sequence_ = 0;  ///< sequence number of frame chunks
};

}  // namespace campuswalk::engine::render
