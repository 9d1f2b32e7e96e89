#include "engine/render/passes/channel_pass.h"

#include <algorithm>
#include <string>

#include "engine/render/gl/render_error.h"
#include "engine/render/image/flip_rows.h"
#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

constexpr std::string_view kDefineCutout = "#define CUTOUT\n";
constexpr std::string_view kDefineSeeThrough = "#define SEE_THROUGH\n";

constexpr std::string_view kChannelVertex = R"(
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_color;
uniform mat4 clip_campus;
uniform vec4 camera_plane;    // dot product with a position = distance along the camera axis
uniform usampler2D node_map;  // one texel per vertex
uniform int has_node;         // 0 for the avatar, whose vertices have no node
flat out uint node;
out float camera_depth;
out vec3 normal;
out vec2 uv;
out float alpha;

void main() {
    int columns = textureSize(node_map, 0).x;
    uint own = texelFetch(node_map, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).r;
    node = has_node == 0 ? 0u : (instance_node != 0u ? instance_node : own);
    vec4 position = vec4(instance_position(vertex_position), 1.0);
    camera_depth = dot(camera_plane, position);
    normal = instance_normal(vertex_normal);
    uv = vertex_uv;
    alpha = vertex_color.a;
    gl_Position = clip_campus * position;
}
)";

constexpr std::string_view kChannelFragment = R"(
flat in uint node;
in float camera_depth;
in vec3 normal;
in vec2 uv;
in float alpha;
layout(location = 0) out uint node_out;
layout(location = 1) out float depth_out;
layout(location = 2) out vec4 normal_out;
uniform sampler2D base_color_map;
uniform vec4 base_color;
uniform float alpha_cutoff;

void main() {
#if defined(CUTOUT)
    if (base_color.a * alpha * texture(base_color_map, uv).a < alpha_cutoff) {
        discard;
    }
#elif defined(SEE_THROUGH)
    if (base_color.a * alpha * texture(base_color_map, uv).a < 0.5) {
        discard;
    }
#endif
    node_out = node;
    depth_out = camera_depth;
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    normal_out = vec4((128.0 + 127.0 * n) / 255.0, 1.0);
}
)";

constexpr GLint kNodeUnit = 4;
constexpr std::size_t kNodeColumns = 4096;  // every driver supports textures this wide

// The framebuffer of one image: a buffer per requested channel, and the depth buffer.
class ChannelBuffers {
public:
    ChannelBuffers(const GlFunctions& gl, int width, int height, const ChannelChoice& choice)
        : gl_(gl), width_(width), height_(height) {
        gl.GenFramebuffers(1, &framebuffer_);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        std::array<GLenum, 3> drawn = {GL_NONE, GL_NONE, GL_NONE};
        const std::array<bool, 3> requested = {choice.nodes, choice.depth, choice.normals};
        const std::array<GLenum, 3> formats = {GL_R32UI, GL_R32F, GL_RGBA8};
        for (std::size_t i = 0; i < requested.size(); ++i) {
            if (requested[i]) {
                drawn[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
                attach(buffers_[i], drawn[i], formats[i]);
            }
        }
        attach(buffers_[3], GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
        gl.DrawBuffers(static_cast<GLsizei>(drawn.size()), drawn.data());
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            throw RenderError("the OpenGL driver can't render channels of " + std::to_string(width) + "x" +
                              std::to_string(height) + " pixels");
        }
        clear(requested);
    }
    ChannelBuffers(const ChannelBuffers&) = delete;
    ChannelBuffers& operator=(const ChannelBuffers&) = delete;
    ~ChannelBuffers() {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }

    template <typename Value>
    std::vector<Value> read(GLuint channel, GLenum format, GLenum type, std::size_t values_per_pixel) const {
        const std::size_t row = values_per_pixel * static_cast<std::size_t>(width_);
        std::vector<Value> values(row * static_cast<std::size_t>(height_));
        gl_.ReadBuffer(GL_COLOR_ATTACHMENT0 + channel);
        gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl_.ReadPixels(0, 0, width_, height_, format, type, values.data());
        flip_rows(values, row);
        return values;
    }

private:
    void attach(GLuint& buffer, GLenum attachment, GLenum format) const {
        gl_.GenRenderbuffers(1, &buffer);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, format, width_, height_);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    }

    void clear(const std::array<bool, 3>& requested) const {
        gl_.Viewport(0, 0, width_, height_);
        gl_.Enable(GL_DEPTH_TEST);
        gl_.DepthFunc(GL_GEQUAL);
        gl_.DepthMask(GL_TRUE);
        gl_.Disable(GL_BLEND);
        const GLfloat far_away = 0.0F;
        gl_.ClearBufferfv(GL_DEPTH, 0, &far_away);
        const std::array<GLuint, 4> no_node = {0, 0, 0, 0};
        const std::array<GLfloat, 4> nothing = {0, 0, 0, 0};
        if (requested[0]) {
            gl_.ClearBufferuiv(GL_COLOR, 0, no_node.data());
        }
        for (GLint i = 1; i < 3; ++i) {
            if (requested[static_cast<std::size_t>(i)]) {
                gl_.ClearBufferfv(GL_COLOR, i, nothing.data());
            }
        }
    }

    const GlFunctions& gl_;
    int width_;
    int height_;
    GLuint framebuffer_ = 0;
    std::array<GLuint, 4> buffers_ = {0, 0, 0, 0};  // nodes, depth, normals, depth test
};

/// Channels need the same program for every material.
ProgramSelector always(const ShaderProgram& program) {
    return [&program](const scene::Material&) -> const ShaderProgram& { return program; };
}

Image opaque_image(int width, int height, std::vector<std::uint8_t> rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) {
        rgba[i] = 255;
    }
    return {width, height, std::move(rgba)};
}

}  // namespace

ChannelPass::ChannelPass(const GlFunctions& gl, const CampusGeometry& geometry)
    : gl_(gl),
      opaque_(program("opaque channels", "")),
      cutout_(program("cut-out channels", kDefineCutout)),
      see_through_(program("see-through channels", kDefineSeeThrough)) {
    upload_nodes(geometry);
}

ChannelPass::~ChannelPass() {
    gl_.DeleteTextures(1, &nodes_);
}

ShaderProgram ChannelPass::program(const char* name, std::string_view define) const {
    return {gl_,
            name,
            {shaders::kVersion, shaders::kInstanceChunk, kChannelVertex},
            {shaders::kVersion, define, kChannelFragment}};
}

void ChannelPass::upload_nodes(const CampusGeometry& geometry) {
    const std::size_t rows =
        std::max<std::size_t>(1, (geometry.vertices.size() + kNodeColumns - 1) / kNodeColumns);
    GLint max_rows = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_rows);
    if (rows > static_cast<std::size_t>(max_rows)) {
        throw RenderError("a campus of " + std::to_string(geometry.vertices.size()) +
                          " vertices is too large for channels: the maximum is " +
                          std::to_string(kNodeColumns * static_cast<std::size_t>(max_rows)));
    }
    std::vector<std::uint32_t> numbers(rows * kNodeColumns, 0);
    for (std::size_t i = 0; i < geometry.placements.size(); ++i) {
        const bool last = i + 1 == geometry.placements.size();
        const std::size_t end = last ? geometry.vertices.size() : geometry.placements[i + 1].first_vertex;
        std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(geometry.placements[i].first_vertex),
                  numbers.begin() + static_cast<std::ptrdiff_t>(end), geometry.placements[i].node);
    }
    gl_.GenTextures(1, &nodes_);
    gl_.BindTexture(GL_TEXTURE_2D, nodes_);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, static_cast<GLsizei>(kNodeColumns), static_cast<GLsizei>(rows),
                   0, GL_RED_INTEGER, GL_UNSIGNED_INT, numbers.data());
}

void ChannelPass::begin(const ShaderProgram& program, const Viewpoint& view,
                        const Eigen::Matrix4d& clip_campus, const Eigen::Vector3d& eye) const {
    program.use();
    program.set("clip_campus", clip_campus);
    Eigen::Vector4d plane;
    plane.head<3>() = -view.R_world_camera.col(2);
    plane.w() = -plane.head<3>().dot(eye);
    program.set("camera_plane", plane);
    program.set("base_color_map", 0);
    program.set("node_map", kNodeUnit);
    program.set("has_node", 1);
    gl_.ActiveTexture(GL_TEXTURE0 + kNodeUnit);
    gl_.BindTexture(GL_TEXTURE_2D, nodes_);
}

Channels ChannelPass::draw(const ChannelScene& scene, const Viewpoint& view,
                           const Eigen::Matrix4d& clip_campus, const Eigen::Vector3d& eye, int width,
                           int height, const ChannelChoice& choice) const {
    const ChannelBuffers buffers(gl_, width, height, choice);
    const Frustum frustum(clip_campus);
    begin(opaque_, view, clip_campus, eye);
    if (scene.figure != nullptr) {
        opaque_.set("has_node", 0);
        scene.campus.set_plain_material(opaque_);
        scene.figure->bind();
        scene.figure->draw(0, scene.figure_indices);
        opaque_.set("has_node", 1);
    }
    scene.campus.draw_solid(always(opaque_), scene::AlphaMode::opaque, frustum, eye);
    begin(cutout_, view, clip_campus, eye);
    scene.campus.draw_solid(always(cutout_), scene::AlphaMode::mask, frustum, eye);
    begin(see_through_, view, clip_campus, eye);
    scene.campus.draw_blend(always(see_through_), frustum, eye);

    Channels channels;
    channels.width = width;
    channels.height = height;
    if (choice.nodes) {
        channels.nodes = buffers.read<std::uint32_t>(0, GL_RED_INTEGER, GL_UNSIGNED_INT, 1);
    }
    if (choice.depth) {
        channels.depth = buffers.read<float>(1, GL_RED, GL_FLOAT, 1);
    }
    if (choice.normals) {
        channels.normals =
            opaque_image(width, height, buffers.read<std::uint8_t>(2, GL_RGBA, GL_UNSIGNED_BYTE, 4));
    }
    return channels;
}

}  // namespace campuswalk::engine::render
