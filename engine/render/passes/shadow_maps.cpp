#include "engine/render/passes/shadow_maps.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::engine::render {
namespace {

// Usable half extent of the near map: at its border the PCF samples would reach into the far map.
constexpr double kNearHalfExtent = 0.49;
// Texels that the lookup position is moved along the surface normal, against self-shadowing.
constexpr double kNormalOffset = 1.6;
// Offset of the four PCF samples on both axes, texels.
constexpr double kPcfOffset = 0.85;
// Texture coordinates that no surface has.
constexpr double kOutsideTexture = -1000.0;

// Projects the box from `low` to `high` (sun frame); depth 0 is the side towards the sun.
void fit_to_box(ShadowMap& map, const Eigen::Matrix3d& R_sun_campus, const Eigen::Vector3d& low,
                const Eigen::Vector3d& high) {
    const Eigen::Vector3d size = (high - low).cwiseMax(1.0);
    Eigen::Matrix4d clip_sun = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 2; ++i) {
        clip_sun(i, i) = 2.0 / size[i];
        clip_sun(i, 3) = -(low[i] + high[i]) / size[i];
    }
    clip_sun(2, 2) = -1.0 / size.z();
    clip_sun(2, 3) = high.z() / size.z();
    Eigen::Matrix4d sun_campus = Eigen::Matrix4d::Identity();
    sun_campus.topLeftCorner<3, 3>() = R_sun_campus;
    map.clip_campus = clip_sun * sun_campus;
    map.metres_per_texel = std::max(size.x(), size.y()) / map.size;
}

// From clip coordinates (-1 to 1) to coordinates within a map (0 to 1).
Eigen::Matrix4d unit_from_clip() {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m(0, 0) = m(1, 1) = 0.5;
    m(0, 3) = m(1, 3) = 0.5;
    return m;
}

}  // namespace

ShadowMaps::ShadowMaps(const GlFunctions& gl, const RenderSettings& settings, const CampusGeometry& geometry,
                       const GpuCampus& campus, const ShaderProgram& opaque, const ShaderProgram& masked)
    : gl_(gl), settings_(settings), campus_(campus), opaque_(opaque), masked_(masked) {
    const Eigen::Vector3d towards = settings.to_sun.normalized();
    const Eigen::Vector3d right = towards.unitOrthogonal();
    R_sun_campus_.row(0) = right.transpose();
    R_sun_campus_.row(1) = towards.cross(right).transpose();
    R_sun_campus_.row(2) = towards.transpose();

    Eigen::AlignedBox3d box;
    for (const Batch& batch : geometry.batches) {
        for (int i = 0; i < 8; ++i) {
            box.extend(R_sun_campus_ * batch.bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
        }
    }
    if (box.isEmpty()) {
        box.extend(Eigen::Vector3d::Zero());
    }
    // A margin in depth, as the avatar may stand outside the bounds of the campus.
    lowest_ = box.min() - Eigen::Vector3d(0, 0, 3);
    highest_ = box.max() + Eigen::Vector3d(0, 0, 3);
    if (!settings.shadows) {
        return;
    }
    far_.size = settings.shadow_size;
    near_.size = settings.near_shadow_size;
    near_.left = far_.size;
    make_texture();
    fit_to_box(far_, R_sun_campus_, lowest_, highest_);
    fit_near(Eigen::Vector3d::Zero());
    draw(far_, nullptr, 0);
}

void ShadowMaps::make_texture() {
    width_ = far_.size + near_.size;
    height_ = std::max(far_.size, near_.size);
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width_, height_, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
    const GLenum none = GL_NONE;
    gl_.DrawBuffers(1, &none);
    gl_.ReadBuffer(GL_NONE);
}

void ShadowMaps::draw_near(const Eigen::Vector3d& eye, const Eigen::Vector3d& forwards, const GpuMesh* figure,
                           std::size_t figure_indices) {
    const Eigen::Vector3d level = Eigen::Vector3d(forwards.x(), 0.0, forwards.z());
    fit_near(eye + 0.75 * settings_.near_shadow_radius * level);
    draw(near_, figure, figure_indices);
}

void ShadowMaps::fit_near(const Eigen::Vector3d& centre) {
    const double radius = settings_.near_shadow_radius;
    const Eigen::Vector3d in_sun = R_sun_campus_ * centre;
    // Snapped to whole texels, so that shadow edges don't shimmer between images.
    const double texel = 2.0 * radius / near_.size;
    Eigen::Vector3d low = lowest_;
    Eigen::Vector3d high = highest_;
    for (int i = 0; i < 2; ++i) {
        const double snapped = texel * std::round(in_sun[i] / texel);
        low[i] = snapped - radius;
        high[i] = snapped + radius;
    }
    fit_to_box(near_, R_sun_campus_, low, high);
}

void ShadowMaps::draw(const ShadowMap& map, const GpuMesh* figure, std::size_t figure_indices) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(map.left, 0, map.size, map.size);
    gl_.Enable(GL_SCISSOR_TEST);  // for the clear, which ignores the viewport
    gl_.Scissor(map.left, 0, map.size, map.size);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(1.0);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    // Both sides cast shadows: many models have single-sheet walls, facing the sun or not.
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1.5F, 2.0F);
    campus_.draw_depth(opaque_, masked_, map.clip_campus);
    if (figure != nullptr) {
        opaque_.use();
        opaque_.set("clip_campus", map.clip_campus);
        figure->bind();
        figure->draw(0, figure_indices);
    }
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    gl_.Disable(GL_SCISSOR_TEST);
}

Eigen::Vector2d ShadowMaps::share(const ShadowMap& map) const {
    return {static_cast<double>(map.size) / width_, static_cast<double>(map.size) / height_};
}

// The near map shares the far map's axes and depth, so near coordinates are far ones scaled and shifted.
Eigen::Vector2d ShadowMaps::near_scale() const {
    return (near_.clip_campus.topLeftCorner<2, 3>().rowwise().norm().array() /
            far_.clip_campus.topLeftCorner<2, 3>().rowwise().norm().array() * share(near_).array())
        .matrix();
}

ShaderConstants ShadowMaps::constants() const {
    ShaderConstants constants;
    if (!settings_.shadows) {
        return constants;
    }
    const Eigen::Matrix4d unit_campus = unit_from_clip() * far_.clip_campus;
    const Eigen::Vector2d left(static_cast<double>(near_.left) / width_, 0.0);
    constants.add("far_axes", Eigen::Matrix3d(unit_campus.topLeftCorner<3, 3>()))
        .add("far_origin", Eigen::Vector3d(unit_campus.topRightCorner<3, 1>()))
        .add("far_scale", share(far_))
        .add("near_scale", near_scale())
        .add("near_centre", Eigen::Vector2d(left + 0.5 * share(near_)))
        .add("near_half_extent", Eigen::Vector2d(kNearHalfExtent * share(near_)))
        .add("far_normal_offset", kNormalOffset * far_.metres_per_texel)
        .add("near_normal_offset", kNormalOffset * near_.metres_per_texel)
        .add("pcf_offset", Eigen::Vector2d(kPcfOffset / width_, kPcfOffset / height_));
    return constants;
}

void ShadowMaps::bind(const ShaderProgram& surface, bool with_near) const {
    if (!settings_.shadows) {
        return;
    }
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    surface.set("shadow_map", 1);
    // The campus origin in the coordinates of a map.
    const auto origin_in = [](const ShadowMap& map) -> Eigen::Vector2d {
        return (unit_from_clip() * map.clip_campus).topRightCorner<2, 1>();
    };
    const Eigen::Vector2d in_near = Eigen::Vector2d(static_cast<double>(near_.left) / width_, 0.0) +
                                    share(near_).cwiseProduct(origin_in(near_));
    const Eigen::Vector2d offset = in_near - near_scale().cwiseProduct(origin_in(far_));
    surface.set("near_origin", with_near ? offset : Eigen::Vector2d(kOutsideTexture, kOutsideTexture));
}

}  // namespace campuswalk::engine::render
