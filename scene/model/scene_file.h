#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/base/diagnostic.h"

namespace campuswalk::scene {

enum class UpAxis { y, z };

/// Where a model is put, from the frame that SceneFile gives it.
struct ScenePlacement {
    SourceMark mark;
    std::string name;  ///< of the node above the model's; empty: none if it is the only placement, else
                       ///< `FILE#1`, `FILE#2`, …
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double scale = 1.0;
};

struct SceneFile {
    SourceMark mark;
    std::string file;            ///< as written, for messages
    std::filesystem::path path;  ///< resolved against the campus file's folder
    UpAxis up = UpAxis::y;
    double metres_per_unit = 1.0;  ///< from `unit`
    double scale = 1.0;            ///< multiplies the unit
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::vector<ScenePlacement> placements =
        {};  ///< after all of the above; empty: once, as it is (place_scene.h)
    /// Folders beside those in SceneFolder whose files it may refer to; canonical.
    std::vector<std::filesystem::path> roots = {};
    bool images_beside = true;  ///< images may come from folders beside the file's, such as `../textures`
};

}  // namespace campuswalk::scene
