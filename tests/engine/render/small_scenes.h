#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "engine/render/passes/render_settings.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render::test {

using Color = std::array<float, 4>;  // linear

constexpr Color kRed = {0.8F, 0.02F, 0.02F, 1.0F};
constexpr Color kGreen = {0.02F, 0.6F, 0.02F, 1.0F};
constexpr Color kBlue = {0.02F, 0.02F, 0.8F, 1.0F};
constexpr Color kGrey = {0.4F, 0.4F, 0.4F, 1.0F};

constexpr int kWidth = 160;  // of test images, pixels: llvmpipe draws on the processor
constexpr int kHeight = 90;
constexpr double kFov = 1.0471975511965976;

/// Default settings with small shadow maps.
RenderSettings quick_settings();

/// Builds a model with a node and a mesh per piece.
class SceneBuilder {
public:
    /// A new material for the pieces that follow.
    SceneBuilder& colored(const Color& color, const std::optional<scene::Texture>& texture = {});
    SceneBuilder& alpha(scene::AlphaMode mode, float cutoff = 0.5F);
    SceneBuilder& double_sided();
    SceneBuilder& glow(const std::array<float, 3>& emissive);
    /// An image of the latest material: `&scene::Material::normal_texture`.
    SceneBuilder& image(std::optional<scene::TextureIndex> scene::Material::*use, scene::Texture texture);
    /// The latest material, for settings that have no function here.
    scene::Material& material() { return model_.materials.back(); }
    /// The next piece's node.
    SceneBuilder& placed(const Eigen::Matrix4d& X_world_node);
    SceneBuilder& named(const char* name);

    /// A flat rectangle of `size` that faces +Z; texture coordinates (0, 0) at its upper left corner.
    SceneBuilder& upright(const Eigen::Vector3d& centre, double size);
    SceneBuilder& box(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
    /// A square in the plane y = 0 about the origin.
    SceneBuilder& ground(double size);

    /// As imported: the winding of mirrored nodes is flipped.
    scene::Model model() const;

private:
    void quad(scene::Mesh& mesh, const std::array<Eigen::Vector3d, 4>& vertices) const;
    void add(scene::Mesh mesh);

    scene::Model model_;
    Eigen::Matrix4d next_place_ = Eigen::Matrix4d::Identity();
    std::string next_name_ = "piece";
};

/// Four blocks of colour: red and green above, blue and yellow below.
scene::Texture four_blocks();
/// One uniform colour.
scene::Texture plain_texture(const std::array<std::uint8_t, 4>& rgba);
/// Opaque white on its right half, transparent on its left.
scene::Texture half_clear();

AvatarState avatar_at(const Eigen::Vector3d& position, double yaw, double pitch = 0.0);

/// At the origin, looking along -Z.
Viewpoint ahead();
/// From `height` metres over (x, z), straight down, north up.
Viewpoint from_above(double x, double height, double z);

/// A campus without collision objects. Each building owns the nodes named like its id.
scene::Campus campus_of(scene::Model model, std::vector<scene::Building> buildings = {});

/// A square with a tower on it, the scene of determinism tests.
scene::Model tower_scene();
Viewpoint tower_view();

}  // namespace campuswalk::engine::render::test
