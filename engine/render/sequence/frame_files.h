#pragma once

#include <filesystem>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// Writes `FOLDER/frame-00001.png` and so on. Deletes those of an earlier run first, which may have been
/// longer.
class FrameFiles final : public FrameSink {
public:
    explicit FrameFiles(std::filesystem::path folder);
    void add(const Frame& frame) override;
    void finish() override {}

private:
    std::filesystem::path folder_;
};

}  // namespace campuswalk::engine::render
