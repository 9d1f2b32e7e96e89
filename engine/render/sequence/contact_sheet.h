#pragma once

#include <filesystem>
#include <vector>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// Thumbnails of all frames on one image, row by row, with their times. Beyond `kMaxFrames` only every
/// second, fourth, … is shown.
class ContactSheet final : public FrameSink {
public:
    static constexpr std::size_t kMaxFrames = 120;

    explicit ContactSheet(std::filesystem::path file);
    void add(const Frame& frame) override;
    /// Writes the image; none without frames.
    void finish() override;

private:
    Image sheet() const;

    std::filesystem::path file_;
    std::size_t every_ = 1;      ///< interval of frames shown
    std::vector<Frame> frames_;  ///< thumbnails
};

}  // namespace campuswalk::engine::render
