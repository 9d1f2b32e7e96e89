#pragma once

#include <filesystem>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// `FOLDER/frame-00001.png` and so on. Those of an earlier run are deleted first: a shorter walk would keep
/// the end of a longer one.
class FrameFiles final : public FrameSink {
public:
    explicit FrameFiles(std::filesystem::path folder);
    void add(const Frame& frame) override;
    void finish() override {}

private:
    std::filesystem::path folder_;
};

}  // namespace campuswalk::engine::render
