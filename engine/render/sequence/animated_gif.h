#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>

#include "engine/render/sequence/frame_sink.h"
#include "scene/base/atomic_file.h"

struct GifFileType;

namespace campuswalk::engine::render {

/// An animation in GIF, played for ever, at most kAnimationWidth wide: 252 fixed colours, those between them
/// dithered in a fixed pattern, so that what stands still doesn't flicker. Frames go to disk as they come.
class AnimatedGif final : public FrameSink {
public:
    /// A frame is shown for so many seconds, in steps of 1/100, 2/100 at least: viewers show less as 10/100.
    AnimatedGif(std::filesystem::path file, double seconds_per_frame);
    void add(const Frame& frame) override;
    /// Puts it where it belongs unless there was no frame. Without this there is no file.
    void finish() override;

private:
    /// Where giflib's bytes go; it is C, so that what is thrown there has to wait.
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
    std::unique_ptr<Output> output_;  // before gif_, which writes into it to its very end
    std::unique_ptr<GifFileType, Close> gif_;
};

}  // namespace campuswalk::engine::render
