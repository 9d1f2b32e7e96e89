#pragma once

#include <exception>
#include <filesystem>
#include <memory>

#include "engine/render/sequence/frame_sink.h"
#include "scene/base/atomic_file.h"

struct GifFileType;

namespace campuswalk::engine::render {

/// A looping animated GIF, at most kAnimationWidth wide, with 252 fixed colours and ordered dithering, so
/// that static parts don't flicker. Frames are written as they arrive.
class AnimatedGif final : public FrameSink {
public:
    /// Frame durations are multiples of 0.01 s, at least 0.02: viewers show shorter ones as 0.1 s.
    AnimatedGif(std::filesystem::path file, double seconds_per_frame);
    void add(const Frame& frame) override;
    /// Moves the file into place; writes none without frames.
    void finish() override;

private:
    /// The output of giflib, which is C: exceptions are kept until its functions return.
    struct Output {
        scene::AtomicFile file;
        std::exception_ptr failure;
    };
    static int write(GifFileType* gif, const unsigned char* data, int size);
    void check(int status) const;
    void begin(const Image& image);

    struct Close {
        void operator()(GifFileType* gif) const;
    };
    std::filesystem::path file_;
    int hundredths_;
    std::unique_ptr<Output> output_;  // before gif_, which writes into it until destroyed
    std::unique_ptr<GifFileType, Close> gif_;
};

}  // namespace campuswalk::engine::render
