#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/render/sequence/frame_sink.h"

struct GifFileType;

namespace campuswalk::engine::render {

/// An animation in GIF, played for ever, at most kAnimationWidth wide: 252 fixed colours, those between them
/// dithered in a fixed pattern, so that what stands still doesn't flicker. Kept in memory until it is
/// finished.
class AnimatedGif final : public FrameSink {
public:
    /// A frame is shown for so many seconds, in steps of 1/100, 2/100 at least: viewers show less as 10/100.
    AnimatedGif(std::filesystem::path file, double seconds_a_frame);
    void add(const Frame& frame) override;
    /// Writes it unless there was no frame.
    void finish() override;

private:
    void begin(const Picture& picture);

    struct Close {
        void operator()(GifFileType* gif) const;
    };
    std::filesystem::path file_;
    int hundredths_;
    std::string bytes_;  // before gif_, which writes into it to its very end
    std::unique_ptr<GifFileType, Close> gif_;
};

}  // namespace campuswalk::engine::render
