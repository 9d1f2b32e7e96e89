#pragma once

#include <filesystem>
#include <vector>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// All frames, made small, on one image, row by row, each with its time. Of more than `kMostFrames` every
/// second, third, … is shown.
class ContactSheet final : public FrameSink {
public:
    static constexpr std::size_t kMaxFrames = 120;

    explicit ContactSheet(std::filesystem::path file);
    void add(const Frame& frame) override;
    /// Writes it unless there was no frame.
    void finish() override;

private:
    Image sheet() const;

    std::filesystem::path file_;
    std::size_t every_ = 1;      ///< frame that is kept
    std::vector<Frame> frames_;  ///< small
};

}  // namespace campuswalk::engine::render
