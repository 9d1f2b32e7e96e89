#include "engine/render/passes/ambient_occlusion_pass.h"

#include <cmath>

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

// How much of the hemisphere over a pixel's surface is occluded by anything closer than `radius`, estimated
// from the camera's depth map.
constexpr std::string_view kOcclusionFragment = R"(
uniform sampler2D depth_map;
uniform vec2 map_size;       // pixels
uniform vec2 ray_scale;      // from pixel coordinates to the view ray with z = 1
uniform vec2 ray_offset;
uniform float near_distance;
uniform float radius;             // metres
uniform float pixels_per_radius;  // at a distance of 1 m
out vec2 fragment;                // visibility, distance

// View space, z forwards; very distant where nothing was drawn.
vec3 position_at(vec2 pixel) {
    vec2 p = clamp(floor(pixel), vec2(0.0), map_size - 1.0);
    float z = near_distance / max(texelFetch(depth_map, ivec2(p), 0).r, 0.00002);
    return vec3(p * ray_scale + ray_offset, 1.0) * z;
}

vec3 shorter(vec3 a, vec3 b) {
    return dot(a, a) < dot(b, b) ? a : b;
}

float occlusion_by(vec3 p, vec3 n, vec2 pixel, float per_radius2) {
    vec3 v = position_at(pixel) - p;
    float d2 = dot(v, v);
    float above = dot(v, n) - 0.0024 * p.z - 0.01;  // minus the depth map's quantization error
    return max(0.0, above) * inversesqrt(d2 + 0.0001) * max(0.0, 1.0 - d2 * per_radius2);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 p = position_at(pixel);
    // Normal from finite differences; on each axis the smaller one, as it stays on the same surface.
    vec3 dx = shorter(position_at(pixel + vec2(1, 0)) - p, p - position_at(pixel - vec2(1, 0)));
    vec3 dy = shorter(position_at(pixel + vec2(0, 1)) - p, p - position_at(pixel - vec2(0, 1)));
    vec3 n = normalize(cross(dy, dx));
    float reach = min(pixels_per_radius / p.z, 0.35 * map_size.y);
    // Eight samples on a spiral, rotated per pixel in a 4x4 pattern that the blur removes.
    int turn = (int(pixel.x) & 3) * 4 + (int(pixel.y) & 3);
    float angle = float((turn * 7) & 15) * 0.3926991;
    vec2 x = reach * vec2(cos(angle), sin(angle));
    vec2 y = vec2(-x.y, x.x);
    float r2 = 1.0 / (radius * radius);
    float sum = occlusion_by(p, n, pixel + 0.0625 * x, r2) + occlusion_by(p, n, pixel - 0.1383 * x + 0.1267 * y, r2) +
                occlusion_by(p, n, pixel + 0.0273 * x - 0.3113 * y, r2) + occlusion_by(p, n, pixel + 0.2662 * x + 0.3472 * y, r2) +
                occlusion_by(p, n, pixel - 0.5541 * x - 0.0980 * y, r2) + occlusion_by(p, n, pixel + 0.5803 * x - 0.3690 * y, r2) +
                occlusion_by(p, n, pixel - 0.2111 * x + 0.7845 * y, r2) + occlusion_by(p, n, pixel - 0.4329 * x - 0.8320 * y, r2);
    float open = clamp(1.0 - 0.2125 * sum, 0.25, 1.0);
    // Radii of one or two pixels yield only noise.
    fragment = vec2(mix(1.0, open, smoothstep(1.5, 6.0, reach)), p.z);
}
)";

// Separable depth-aware blur that averages the 4x4 pattern out.
constexpr std::string_view kBlurFragment = R"(
uniform sampler2D occlusion_map;
uniform ivec2 axis;
uniform ivec2 last;  // pixel
out vec2 fragment;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec2 centre = texelFetch(occlusion_map, here, 0).rg;
    vec2 sum = vec2(centre.r, 1.0);
    float sharpness = 12.0 / centre.g;
    for (int i = -2; i <= 1; ++i) {
        if (i != 0) {
            vec2 other = texelFetch(occlusion_map, clamp(here + i * axis, ivec2(0), last), 0).rg;
            sum += max(0.0, 1.0 - sharpness * abs(other.g - centre.g)) * vec2(other.r, 1.0);
        }
    }
    fragment = vec2(sum.x / sum.y, centre.g);
}
)";

}  // namespace

AmbientOcclusionPass::AmbientOcclusionPass(const GlFunctions& gl, const ShaderProgram& opaque,
                                           const ShaderProgram& masked)
    : gl_(gl),
      opaque_(opaque),
      masked_(masked),
      occlusion_(gl, "occlusion", {shaders::kVersion, shaders::kScreenChunk, shaders::kScreenVertex},
                 {shaders::kVersion, kOcclusionFragment}),
      blur_(gl, "occlusion blur", {shaders::kVersion, shaders::kScreenChunk, shaders::kScreenVertex},
            {shaders::kVersion, kBlurFragment}) {
    gl.GenVertexArrays(1, &no_vertices_);
}

AmbientOcclusionPass::~AmbientOcclusionPass() {
    delete_layers();
}

void AmbientOcclusionPass::resize(int width, int height) {
    if (width == image_width_ && height == image_height_) {
        return;
    }
    delete_layers();
    image_width_ = width;
    image_height_ = height;
    width_ = (width + 1) / 2;
    height_ = (height + 1) / 2;
    depth_ = make_layer(GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    raw_ = make_layer(GL_RG16F, GL_COLOR_ATTACHMENT0);
    half_blurred_ = make_layer(GL_RG16F, GL_COLOR_ATTACHMENT0);
    // Sampled bilinearly for every pixel of the image; bytes take half the time of floats.
    blurred_ = make_layer(GL_R8, GL_COLOR_ATTACHMENT0);
}

// GL ignores the name 0, which layers have before the first resize.
void AmbientOcclusionPass::delete_layers() const {
    for (const Layer& layer : {depth_, raw_, half_blurred_, blurred_}) {
        gl_.DeleteFramebuffers(1, &layer.framebuffer);
        gl_.DeleteTextures(1, &layer.texture);
    }
}

AmbientOcclusionPass::Layer AmbientOcclusionPass::make_layer(GLenum format, GLenum attachment) const {
    const bool depth = attachment == GL_DEPTH_ATTACHMENT;
    Layer layer;
    gl_.GenTextures(1, &layer.texture);
    gl_.BindTexture(GL_TEXTURE_2D, layer.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_, height_, 0,
                   depth ? GL_DEPTH_COMPONENT : GL_RG, GL_FLOAT, nullptr);
    const GLint filter = depth ? GL_NEAREST : GL_LINEAR;
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.GenFramebuffers(1, &layer.framebuffer);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, layer.texture, 0);
    if (depth) {
        const GLenum none = GL_NONE;
        gl_.DrawBuffers(1, &none);
        gl_.ReadBuffer(GL_NONE);
    }
    return layer;
}

void AmbientOcclusionPass::draw_full_screen(const Layer& layer) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.BindVertexArray(no_vertices_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void AmbientOcclusionPass::draw(const GpuCampus& campus, const GpuMesh* figure, std::size_t figure_indices,
                                const Viewpoint& view, const Eigen::Matrix4d& clip_campus,
                                double radius) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, depth_.framebuffer);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GEQUAL);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(0.0);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.Disable(GL_CULL_FACE);
    campus.draw_depth(opaque_, masked_, clip_campus);
    if (figure != nullptr) {
        opaque_.use();
        figure->bind();
        figure->draw(0, figure_indices);
    }

    gl_.Disable(GL_DEPTH_TEST);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, depth_.texture);
    const Eigen::Vector2d size(width_, height_);
    const double tangent = std::tan(0.5 * view.fov);
    const Eigen::Vector2d half(tangent * image_width_ / image_height_, tangent);
    occlusion_.use();
    occlusion_.set("depth_map", 0);
    occlusion_.set("map_size", size);
    occlusion_.set("ray_scale", Eigen::Vector2d(2.0 * half.cwiseQuotient(size)));
    occlusion_.set("ray_offset", Eigen::Vector2d(half.cwiseQuotient(size) - half));
    occlusion_.set("near_distance", view.near_distance);
    occlusion_.set("radius", radius);
    occlusion_.set("pixels_per_radius", radius * height_ / (2.0 * tangent));
    draw_full_screen(raw_);
    blur(raw_, half_blurred_, Eigen::Vector2i(1, 0));
    blur(half_blurred_, blurred_, Eigen::Vector2i(0, 1));
    gl_.Enable(GL_DEPTH_TEST);
}

void AmbientOcclusionPass::clear_to_unoccluded() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, blurred_.framebuffer);
    gl_.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void AmbientOcclusionPass::blur(const Layer& from, const Layer& to, const Eigen::Vector2i& axis) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, from.texture);
    blur_.use();
    blur_.set("occlusion_map", 0);
    blur_.set("axis", axis);
    blur_.set("last", Eigen::Vector2i(width_ - 1, height_ - 1));
    draw_full_screen(to);
}

void AmbientOcclusionPass::bind(const ShaderProgram& surface) const {
    gl_.ActiveTexture(GL_TEXTURE3);
    gl_.BindTexture(GL_TEXTURE_2D, blurred_.texture);
    surface.set("occlusion_map", 3);
    surface.set("occlusion_scale", Eigen::Vector2d(0.5 / width_, 0.5 / height_));
}

}  // namespace campuswalk::engine::render
