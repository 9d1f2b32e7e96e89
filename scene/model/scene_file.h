#pragma once

#include <filesystem>
#include <string>
#include <vector>

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
    /// Folders beside those in SceneFolder whose files it may refer to; canonical.
    std::vector<std::filesystem::path> roots = {};
    bool images_beside = true;  ///< images may come from folders beside the file's, such as `../textures`
};

}  // namespace campuswalk::scene
