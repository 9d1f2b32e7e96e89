#pragma once

#include <filesystem>
#include <vector>

namespace campuswalk::engine::render::test {

/// A temporary empty folder, deleted by the destructor.
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
