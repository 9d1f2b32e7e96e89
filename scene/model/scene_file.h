#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "scene/base/diagnostic.h"

namespace campuswalk::scene {

enum class UpAxis { y, z };

struct SceneFile {
    SourceMark mark;
    std::string file;            ///< as written, for messages
    std::filesystem::path path;  ///< resolved against the campus file's folder
    UpAxis up = UpAxis::y;
    double metres_per_unit = 1.0;  ///< from `unit`
    double scale = 1.0;            ///< multiplies the unit
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

}  // namespace campuswalk::scene
