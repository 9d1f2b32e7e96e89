#include "scene/import/gltf/skin.h"

namespace campuswalk::scene::gltf {

Skin read_skin(const Document& document, Accessors& accessors, std::size_t index) {
    const JsonObject item = document.item("skins", index);
    Skin skin;
    skin.joints = item.uints("joints");
    if (skin.joints.empty()) {
        item.fail("has no joints; re-export it");
    }
    const auto matrices = item.uint("inverseBindMatrices");
    if (!matrices) {
        skin.X_joint_bound.assign(skin.joints.size(), Eigen::Matrix4d::Identity());
        return skin;
    }
    skin.X_joint_bound = accessors.matrices(*matrices);
    if (skin.X_joint_bound.size() < skin.joints.size()) {
        item.fail("has " + std::to_string(skin.joints.size()) + " joints and " +
                  std::to_string(skin.X_joint_bound.size()) + " inverse bind matrices; re-export it");
    }
    return skin;
}

}  // namespace campuswalk::scene::gltf
