#pragma once

#include <filesystem>
#include <vector>

namespace campuswalk::engine::render::test {

/// An empty folder that is gone after the test.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Everything in it, at any depth, relative to it and sorted.
    std::vector<std::filesystem::path> contents() const;

private:
    std::filesystem::path path_;
};

}  // namespace campuswalk::engine::render::test
