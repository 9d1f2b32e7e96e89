#include "scene/import/source/file_frame.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include <assimp/scene.h>
#include <Eigen/LU>

namespace campuswalk::scene {
namespace {

constexpr double kMetresPerCentimetre = 0.01;

/// Metres per unit of an FBX file; 1 for other formats.
double metres_per_file_unit(const aiMetadata& metadata) {
    float unit = 0.0F;
    double centimetres = 0.0;
    if (!metadata.Get("UnitScaleFactor", centimetres)) {
        centimetres = metadata.Get("UnitScaleFactor", unit) ? static_cast<double>(unit) : 0.0;
    }
    return std::isfinite(centimetres) && centimetres > 0.0 ? centimetres * kMetresPerCentimetre : 1.0;
}

/// The matrix from an FBX file's axes (right, up, towards the viewer) to +X, +Y, +Z; nullopt for other
/// formats.
std::optional<Eigen::Matrix3d> axes_of(const aiMetadata& metadata) {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
    int row = 0;
    for (const char* name : {"CoordAxis", "UpAxis", "FrontAxis"}) {
        std::int32_t axis = -1;
        std::int32_t sign = 1;
        if (!metadata.Get(name, axis) || axis < 0 || axis > 2) {
            return std::nullopt;
        }
        metadata.Get(std::string(name) + "Sign", sign);
        rotation(row++, axis) = sign < 0 ? -1.0 : 1.0;
    }
    return rotation;
}

/// Those axes; identity for other formats and for axes that are not right-handed.
Eigen::Matrix3d world_from_file_axes(const aiMetadata& metadata) {
    const std::optional<Eigen::Matrix3d> axes = axes_of(metadata);
    return axes && axes->determinant() == 1.0 ? *axes : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

Eigen::Matrix4d placed(const Eigen::Matrix3d& linear, const Eigen::Vector3d& position) {
    Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
    result.topLeftCorner<3, 3>() = linear;
    result.topRightCorner<3, 1>() = position;
    return result;
}

Eigen::Matrix3d upright(UpAxis up) {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    if (up == UpAxis::z) {
        rotation << 1, 0, 0,  //
            0, 0, 1,          //
            0, -1, 0;
    }
    return rotation;
}

}  // namespace

Eigen::Matrix4d world_from_file(const SceneFile& file) {
    return placed(upright(file.up) * (file.metres_per_unit * file.scale), file.position);
}

Eigen::Matrix4d world_from_file(const SceneFile& file, const aiScene& scene) {
    if (scene.mMetaData == nullptr) {
        return world_from_file(file);
    }
    const Eigen::Matrix3d rotation = upright(file.up) * world_from_file_axes(*scene.mMetaData);
    const double scale = file.metres_per_unit * file.scale * metres_per_file_unit(*scene.mMetaData);
    return placed(rotation * scale, file.position);
}

bool has_left_handed_axes(const aiScene& scene) {
    const auto axes = scene.mMetaData != nullptr ? axes_of(*scene.mMetaData) : std::nullopt;
    return axes && axes->determinant() == -1.0;
}

}  // namespace campuswalk::scene
