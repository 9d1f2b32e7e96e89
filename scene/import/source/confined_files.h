#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <assimp/IOSystem.hpp>

#include "scene/import/source/collada_text.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {

/// The whole file, or nullopt when it can't be read.
std::optional<std::vector<std::uint8_t>> read_bytes(const std::filesystem::path& path);

/// What assimp sees of the disk: the scene's folder and nothing else, read only. Names are relative to that
/// folder, so its messages carry no path of this machine.
class ConfinedFiles final : public Assimp::IOSystem {
public:
    /// `metres_per_unit` of the scene: see obj_text.h.
    explicit ConfinedFiles(SceneFolder folder, double metres_per_unit = 1.0)
        : folder_(std::move(folder)), metres_per_unit_(metres_per_unit) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    const SceneFolder& folder() const { return folder_; }
    /// By how much the vertices of an OBJ were moved near the origin, in its units.
    const Eigen::Vector3d& origin() const { return origin_; }
    /// Where a COLLADA file says it is.
    const ColladaGeography& geographic() const { return geographic_; }
    /// Whether faces of an OBJ named texture coordinates that it hasn't.
    bool dropped_uvs() const { return dropped_uvs_; }
    /// Names that were asked for and not given, in order.
    const std::vector<std::string>& refused() const { return refused_; }

private:
    Assimp::IOStream* open_collada(const std::filesystem::path& path);
    Assimp::IOStream* open_obj(const std::filesystem::path& path);

    SceneFolder folder_;
    double metres_per_unit_;
    std::optional<std::vector<std::uint8_t>> obj_;  ///< once opened: mended text, empty if it is as it was
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    ColladaGeography geographic_;
    bool dropped_uvs_ = false;
    std::vector<std::string> refused_;
};

}  // namespace campuswalk::scene
