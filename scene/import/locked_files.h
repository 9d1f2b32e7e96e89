#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <assimp/IOSystem.hpp>

#include "scene/import/scene_folder.h"

namespace campuswalk::scene {

/// The whole file, or nullopt when it can't be read.
std::optional<std::vector<std::uint8_t>> read_bytes(const std::filesystem::path& path);

/// What assimp sees of the disk: the scene's folder and nothing else, read only. Names are relative to that
/// folder, so its messages carry no path of this machine.
class LockedFiles final : public Assimp::IOSystem {
public:
    explicit LockedFiles(SceneFolder folder) : folder_(std::move(folder)) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    const SceneFolder& folder() const { return folder_; }
    /// Names that were asked for and not given, in order.
    const std::vector<std::string>& refused() const { return refused_; }

private:
    SceneFolder folder_;
    std::vector<std::string> refused_;
};

}  // namespace campuswalk::scene
