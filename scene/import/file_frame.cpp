#include "scene/import/file_frame.h"

#include <cmath>

#include <assimp/scene.h>

namespace campuswalk::scene {
namespace {

constexpr double kMetresPerCentimetre = 0.01;

/// Metres a unit of an FBX file, 1 for every other format.
double metres_per_file_unit(const aiScene& scene) {
    double centimetres = 0.0;
    if (scene.mMetaData == nullptr || !scene.mMetaData->Get("UnitScaleFactor", centimetres)) {
        float value = 0.0F;
        if (scene.mMetaData == nullptr || !scene.mMetaData->Get("UnitScaleFactor", value)) {
            return 1.0;
        }
        centimetres = static_cast<double>(value);
    }
    return std::isfinite(centimetres) && centimetres > 0.0 ? centimetres * kMetresPerCentimetre : 1.0;
}

}  // namespace

Eigen::Matrix4d house_from_file(const SceneFile& file, const aiScene& scene) {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    if (file.up == UpAxis::z) {
        rotation << 1, 0, 0,  //
            0, 0, 1,          //
            0, -1, 0;
    }
    Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
    result.topLeftCorner<3, 3>() =
        rotation * (file.metres_per_unit * file.scale * metres_per_file_unit(scene));
    result.topRightCorner<3, 1>() = file.position;
    return result;
}

}  // namespace campuswalk::scene
