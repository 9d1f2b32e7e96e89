#include "tests/engine/render/small_scenes.h"

#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "collision/world/broad_phase.h"
#include "scene/import/source/mirror_meshes.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr int kTextureSide = 16;  // texels

template <typename ColorAt>
scene::Texture texture_of(const char* name, ColorAt color_at) {
    scene::Texture texture;
    texture.name = name;
    texture.width = texture.height = kTextureSide;
    texture.wrap = {scene::Wrap::clamp, scene::Wrap::clamp};
    for (int y = 0; y < kTextureSide; ++y) {
        for (int x = 0; x < kTextureSide; ++x) {
            const std::array<std::uint8_t, 4> rgba = color_at(x >= kTextureSide / 2, y >= kTextureSide / 2);
            texture.rgba.insert(texture.rgba.end(), rgba.begin(), rgba.end());
        }
    }
    return texture;
}

}  // namespace

RenderSettings quick_settings() {
    RenderSettings settings;
    settings.shadow_size = 512;
    settings.near_shadow_size = 512;
    return settings;
}

SceneBuilder& SceneBuilder::colored(const Color& color, const std::optional<scene::Texture>& texture) {
    scene::Material material;
    material.base_color = color;
    if (texture) {
        model_.materials.push_back(material);
        return image(&scene::Material::base_color_texture, *texture);
    }
    model_.materials.push_back(material);
    return *this;
}

SceneBuilder& SceneBuilder::image(std::optional<scene::TextureIndex> scene::Material::*use,
                                  scene::Texture texture) {
    model_.materials.back().*use = scene::TextureIndex{static_cast<std::uint32_t>(model_.textures.size())};
    model_.textures.push_back(std::move(texture));
    return *this;
}

SceneBuilder& SceneBuilder::alpha(scene::AlphaMode mode, float cutoff) {
    model_.materials.back().alpha_mode = mode;
    model_.materials.back().alpha_cutoff = cutoff;
    return *this;
}

SceneBuilder& SceneBuilder::double_sided() {
    model_.materials.back().double_sided = true;
    return *this;
}

SceneBuilder& SceneBuilder::glow(const std::array<float, 3>& emissive) {
    model_.materials.back().emissive = emissive;
    return *this;
}

SceneBuilder& SceneBuilder::placed(const Eigen::Matrix4d& X_world_node) {
    next_place_ = X_world_node;
    return *this;
}

SceneBuilder& SceneBuilder::named(const char* name) {
    next_name_ = name;
    return *this;
}

// Vertices counter-clockwise from the lower left as seen from outside.
void SceneBuilder::quad(scene::Mesh& mesh, const std::array<Eigen::Vector3d, 4>& vertices) const {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Eigen::Vector3d normal = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]).normalized();
    for (const Eigen::Vector3d& vertex : vertices) {
        mesh.positions.push_back(vertex.cast<float>());
        mesh.normals.push_back(normal.cast<float>());
    }
    mesh.uvs.insert(mesh.uvs.end(), {{0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

void SceneBuilder::add(scene::Mesh mesh) {
    mesh.material = scene::MaterialIndex{static_cast<std::uint32_t>(model_.materials.size() - 1)};
    scene::Node node;
    node.name = std::exchange(next_name_, "piece");
    node.X_world_node = std::exchange(next_place_, Eigen::Matrix4d::Identity());
    node.meshes.push_back(scene::MeshIndex{static_cast<std::uint32_t>(model_.meshes.size())});
    model_.meshes.push_back(std::move(mesh));
    model_.nodes.push_back(std::move(node));
}

SceneBuilder& SceneBuilder::upright(const Eigen::Vector3d& centre, double size) {
    const double h = 0.5 * size;
    scene::Mesh mesh;
    quad(mesh, {centre + Eigen::Vector3d(-h, -h, 0), centre + Eigen::Vector3d(h, -h, 0),
                centre + Eigen::Vector3d(h, h, 0), centre + Eigen::Vector3d(-h, h, 0)});
    add(std::move(mesh));
    return *this;
}

SceneBuilder& SceneBuilder::box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const bool upper : {false, true}) {
            std::array<Eigen::Vector3d, 4> vertices = {low, low, low, low};
            for (Eigen::Vector3d& vertex : vertices) {
                vertex[axis] = upper ? high[axis] : low[axis];
            }
            // u x v is the outward axis of the upper side; the lower one goes round the other way.
            const int second = upper ? u : v;
            const int last = upper ? v : u;
            vertices[1][second] = vertices[2][second] = high[second];
            vertices[2][last] = vertices[3][last] = high[last];
            quad(mesh, vertices);
        }
    }
    add(std::move(mesh));
    return *this;
}

SceneBuilder& SceneBuilder::ground(double size) {
    const double h = 0.5 * size;
    scene::Mesh mesh;
    quad(mesh, {Eigen::Vector3d(-h, 0, h), Eigen::Vector3d(h, 0, h), Eigen::Vector3d(h, 0, -h),
                Eigen::Vector3d(-h, 0, -h)});
    add(std::move(mesh));
    return *this;
}

scene::Model SceneBuilder::model() const {
    scene::Model model = model_;
    scene::mirror_meshes(model);
    return model;
}

scene::Texture four_blocks() {
    return texture_of("four-blocks", [](bool right, bool lower) -> std::array<std::uint8_t, 4> {
        if (lower) {
            return right ? std::array<std::uint8_t, 4>{220, 220, 30, 255}
                         : std::array<std::uint8_t, 4>{30, 30, 220, 255};
        }
        return right ? std::array<std::uint8_t, 4>{30, 220, 30, 255}
                     : std::array<std::uint8_t, 4>{220, 30, 30, 255};
    });
}

scene::Texture plain_texture(const std::array<std::uint8_t, 4>& rgba) {
    return texture_of("plain", [&](bool, bool) { return rgba; });
}

scene::Texture half_clear() {
    return texture_of("half-clear", [](bool right, bool) -> std::array<std::uint8_t, 4> {
        return {255, 255, 255, static_cast<std::uint8_t>(right ? 255 : 0)};
    });
}

AvatarState avatar_at(const Eigen::Vector3d& position, double yaw, double pitch) {
    AvatarState avatar;
    avatar.position = position;
    avatar.yaw = yaw;
    avatar.pitch = pitch;
    return avatar;
}

Viewpoint ahead() {
    return looking(Eigen::Vector3d::Zero(), 0.0, 0.0, kFov);
}

Viewpoint from_above(double x, double height, double z) {
    return looking({x, height, z}, 0.0, -1.5707963267948966, kFov);
}

scene::Campus campus_of(scene::Model model, std::vector<scene::Building> buildings) {
    scene::Campus campus{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
    campus.models.push_back(std::move(model));
    for (scene::Building& building : buildings) {
        scene::NodeGlob& glob = building.nodes.emplace_back();
        glob.pattern = building.id;
    }
    campus.description.buildings = std::move(buildings);
    return campus;
}

scene::Model tower_scene() {
    return SceneBuilder()
        .colored(kGrey)
        .ground(40.0)
        .colored(kRed, four_blocks())
        .named("tower")
        .box({-2, 0, -12}, {2, 7, -8})
        .colored({1, 1, 1, 1}, half_clear())
        .alpha(scene::AlphaMode::mask)
        .double_sided()
        .upright({4, 1, -7}, 2.0)
        .colored({0.5F, 0.7F, 0.9F, 0.4F})
        .alpha(scene::AlphaMode::blend)
        .upright({-4, 1, -7}, 2.0)
        .model();
}

Viewpoint tower_view() {
    return looking({1, 1.65, 2}, 0.1, 0.05, kFov);
}

}  // namespace campuswalk::engine::render::test
