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

/// Assimp's access to the disk: the scene's folder only, read only. Names are relative to that folder, so
/// that assimp's messages contain no absolute paths. Text that assimp can't handle is corrected on the fly.
class ConfinedFiles final : public Assimp::IOSystem {
public:
    /// `metres_per_unit`: for move_vertices_near.
    explicit ConfinedFiles(SceneFolder folder, double metres_per_unit = 1.0)
        : folder_(std::move(folder)), metres_per_unit_(metres_per_unit) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    const SceneFolder& folder() const { return folder_; }
    /// What move_vertices_near subtracted from an OBJ's vertices, in its units.
    const Eigen::Vector3d& origin() const { return origin_; }
    const ColladaGeography& geographic() const { return collada_.geography; }
    /// Why a COLLADA, OBJ or OFF file wasn't opened; empty if it was.
    const std::string& fault() const { return fault_; }
    /// Whether drop_absent_uvs changed an OBJ.
    bool dropped_uvs() const { return dropped_uvs_; }
    /// Whether a material file moves images, which is ignored.
    bool moves_images() const { return moves_images_; }
    /// Names of the files that were missing or refused, in order.
    const std::vector<std::string>& refused() const { return refused_; }

private:
    Assimp::IOStream* open_collada(const std::filesystem::path& path);
    Assimp::IOStream* open_obj(const std::filesystem::path& path);
    Assimp::IOStream* open_mtl(const std::filesystem::path& path);
    Assimp::IOStream* open_off(const std::filesystem::path& path);

    SceneFolder folder_;
    double metres_per_unit_;
    std::optional<std::vector<std::uint8_t>> obj_;  ///< once opened: corrected text
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    ColladaFacts collada_;
    std::string fault_;
    bool dropped_uvs_ = false;
    bool moves_images_ = false;
    std::vector<std::string> refused_;
};

}  // namespace campuswalk::scene
