#include "engine/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/LU>

#include "engine/render/geometry/avatar_figure.h"
#include "engine/render/geometry/campus_geometry.h"
#include "engine/render/geometry/sky_view.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/render_error.h"
#include "engine/render/gl/render_target.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/image/fxaa.h"
#include "engine/render/passes/ambient_occlusion_pass.h"
#include "engine/render/passes/channel_pass.h"
#include "engine/render/passes/gpu_campus.h"
#include "engine/render/passes/hierarchical_z.h"
#include "engine/render/passes/line_pass.h"
#include "engine/render/passes/shader_constants.h"
#include "engine/render/passes/shaders.h"
#include "engine/render/passes/shadow_maps.h"
#include "engine/render/passes/surface_programs.h"

namespace campuswalk::engine::render {
namespace {

// Around the campus on a plan; linear.
const Eigen::Vector3d kBackground(0.60, 0.61, 0.59);

// Sky view factors: at or below the first the camera is indoors, at or above the second outdoors.
constexpr double kIndoorSkyView = 0.06;
constexpr double kOutdoorSkyView = 0.42;

std::unique_ptr<GlContext> made_current(std::unique_ptr<GlContext> context) {
    context->make_current();
    return context;
}

}  // namespace

class Renderer::Impl {
public:
    Impl(std::span<const scene::Model> models, const RenderSettings& settings,
         std::unique_ptr<GlContext> context)
        : settings_(settings),
          context_(made_current(std::move(context))),
          gl_(load_gl_functions(*context_)),
          geometry_(bake(models, settings.cell_size, settings.instancing)),
          campus_(reversed_depth(gl_), geometry_),
          figure_mesh_(gl_),
          depth_(gl_, "depth", {shaders::kVersion, shaders::kInstanceChunk, shaders::kDepthVertex},
                 {shaders::kVersion, shaders::kDepthFragment}),
          masked_depth_(gl_, "masked depth",
                        {shaders::kVersion, shaders::kInstanceChunk, shaders::kDepthVertex},
                        {shaders::kVersion, shaders::kMaskedDepthFragment}),
          sky_(gl_, "sky", {shaders::kVersion, shaders::kScreenChunk, shaders::kSkyVertex},
               {shaders::kVersion, light_constants(settings_).text(), shaders::kSkyChunk, shaders::kSrgbChunk,
                shaders::kSkyFragment}),
          shadows_(gl_, settings_, geometry_, campus_, depth_, masked_depth_),
          surfaces_(gl_, settings_.shadows, settings_.ambient_occlusion_radius > 0.0,
                    light_constants(settings_).add(shadows_.constants()).text()),
          occlusion_(gl_, depth_, masked_depth_),
          hierarchical_z_(gl_, settings_.samples) {
        gl_.GenVertexArrays(1, &no_vertices_);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    // Members delete GL objects by name, so their own context must be current.
    ~Impl() {
        try {
            context_->make_current();
        } catch (const RenderError&) {
            // The context is lost, and its objects with it.
        }
    }

    Image draw(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure,
               std::span<const OverlayLine> lines) {
        context_->make_current();
        if (settings_.supersampling > 1) {
            RenderTarget::check_size(gl_, width, height, 2);
            return downsampled_by_two(draw_once(view, 2 * width, 2 * height, figure, lines));
        }
        Image image = draw_once(view, width, height, figure, lines);
        return settings_.fxaa ? apply_fxaa(image) : std::move(image);
    }

    Image draw_once(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure,
                    std::span<const OverlayLine> lines) {
        fit_target(width, height);
        occlusion_.resize(width, height);
        PassInputs inputs;
        inputs.eye = view.position - geometry_.origin;
        inputs.clip_campus = clip_from_campus(view, static_cast<double>(width) / height);
        inputs.perspective = view.projection == Projection::perspective;
        inputs.indoor_share = indoor_share(inputs);
        inputs.figure = figure ? upload(*figure) : nullptr;
        inputs.near_shadows = settings_.shadows && inputs.perspective;
        inputs.occlusion = inputs.perspective && settings_.ambient_occlusion_radius > 0.0;
        if (inputs.near_shadows) {
            shadows_.draw_near(inputs.eye, -view.R_world_camera.col(2), inputs.figure, figure_indices_);
        }
        if (inputs.occlusion) {
            occlusion_.draw(campus_, inputs.figure, figure_indices_, view, inputs.clip_campus,
                            settings_.ambient_occlusion_radius);
        } else {
            occlusion_.clear_to_unoccluded();
        }
        target_->begin(kBackground);
        // Opaque surfaces encode sRGB in the shader; blending needs linear light.
        gl_.Disable(GL_FRAMEBUFFER_SRGB);
        draw_solid(inputs);
        if (inputs.perspective) {
            draw_sky(view, width, height);
        }
        gl_.Enable(GL_FRAMEBUFFER_SRGB);
        draw_blended(inputs);
        if (!lines.empty()) {
            if (!lines_) {
                lines_ = std::make_unique<LinePass>(gl_);
            }
            lines_->draw(lines, inputs.clip_campus, geometry_.origin, width, height);
        }
        return target_->finish();
    }

    Channels draw_channels(const Viewpoint& view, int width, int height, const ChannelChoice& choice,
                           const std::optional<Figure>& figure) {
        context_->make_current();
        RenderTarget::check_size(gl_, width, height);
        if (!channels_) {
            channels_ = std::make_unique<ChannelPass>(gl_, geometry_);
        }
        const ChannelScene scene{campus_, figure ? upload(*figure) : nullptr, figure_indices_};
        return channels_->draw(scene, view, clip_from_campus(view, static_cast<double>(width) / height),
                               view.position - geometry_.origin, width, height, choice);
    }

    const scene::Bounds& bounds() const { return geometry_.bounds; }

private:
    // What the passes of one image share.
    struct PassInputs {
        Eigen::Vector3d eye = Eigen::Vector3d::Zero();  // campus frame
        double indoor_share = 0.0;                      // 1 in a room
        Eigen::Matrix4d clip_campus = Eigen::Matrix4d::Identity();
        bool perspective = true;
        bool near_shadows = false;
        bool occlusion = false;
        const GpuMesh* figure = nullptr;
    };

    // Reversed depth needs a clip space of 0 to 1; set before anything is drawn.
    static const GlFunctions& reversed_depth(const GlFunctions& gl) {
        gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        gl.Enable(GL_FRAMEBUFFER_SRGB);
        gl.FrontFace(GL_CCW);
        return gl;
    }

    void fit_target(int width, int height) {
        if (!target_ || target_->width() != width || target_->height() != height) {
            target_.reset();
            target_ = std::make_unique<RenderTarget>(gl_, width, height, settings_.samples);
        }
    }

    double indoor_share(const PassInputs& inputs) const {
        if (!inputs.perspective) {
            return 0.0;
        }
        const double open = sky_view_factor(geometry_, inputs.eye);
        return std::clamp((kOutdoorSkyView - open) / (kOutdoorSkyView - kIndoorSkyView), 0.0, 1.0);
    }

    Eigen::Matrix4d clip_from_campus(const Viewpoint& view, double aspect) const {
        Eigen::Matrix4d world_campus = Eigen::Matrix4d::Identity();
        world_campus.topRightCorner<3, 1>() = geometry_.origin;
        return clip_from_world(view, aspect) * world_campus;
    }

    const GpuMesh* upload(const Figure& figure) {
        const FigureMesh mesh = make_figure(figure.avatar, figure.profile, figure.stride, geometry_.origin);
        figure_mesh_.upload_vertices(mesh.vertices);
        figure_mesh_.upload_indices(mesh.indices);
        figure_indices_ = mesh.indices.size();
        return &figure_mesh_;
    }

    void begin_surface(const ShaderProgram& surface, const PassInputs& inputs) const {
        surface.use();
        surface.set("clip_campus", inputs.clip_campus);
        surface.set("eye", inputs.eye);
        surface.set("indoor_share", inputs.indoor_share);
        const bool fog = inputs.perspective && settings_.fog_distance > 0.0;
        surface.set("fog_density", fog ? 1.0 / settings_.fog_distance : 0.0);
        surface.set("base_color_map", 0);
        shadows_.bind(surface, inputs.near_shadows);
        occlusion_.bind(surface);
    }

    void draw_solid(const PassInputs& inputs) {
        const Frustum frustum(inputs.clip_campus);
        HierarchicalZ* depth = settings_.occlusion_culling && inputs.perspective ? &hierarchical_z_ : nullptr;
        if (depth != nullptr) {
            depth->begin(*target_, inputs.clip_campus);
        }
        gl_.Disable(GL_BLEND);
        if (inputs.figure != nullptr) {
            const ShaderProgram& plain = surfaces_.of({});
            begin_surface(plain, inputs);
            campus_.set_plain_material(plain);
            inputs.figure->bind();
            inputs.figure->draw(0, figure_indices_);
        }
        const ProgramSelector program_of = prepared_programs(inputs);
        campus_.draw_solid(program_of, scene::AlphaMode::opaque, frustum, inputs.eye, depth);
        if (settings_.samples > 1) {
            gl_.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        }
        campus_.draw_solid(program_of, scene::AlphaMode::mask, frustum, inputs.eye, depth);
        gl_.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    }

    void draw_sky(const Viewpoint& view, int width, int height) const {
        const double tangent = std::tan(0.5 * view.fov);
        sky_.use();
        sky_.set("ray_centre", Eigen::Vector3d(-view.R_world_camera.col(2)));
        sky_.set("ray_right", Eigen::Vector3d(tangent * width / height * view.R_world_camera.col(0)));
        sky_.set("ray_up", Eigen::Vector3d(tangent * view.R_world_camera.col(1)));
        gl_.Disable(GL_CULL_FACE);
        gl_.DepthMask(GL_FALSE);
        gl_.BindVertexArray(no_vertices_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        gl_.DepthMask(GL_TRUE);
    }

    // Selects surface programs; each gets its per-image uniforms on first use.
    ProgramSelector prepared_programs(const PassInputs& inputs) {
        return [this, &inputs, begun = std::set<const ShaderProgram*>()](
                   const scene::Material& material) mutable -> const ShaderProgram& {
            const ShaderProgram& program = surfaces_.of(kind_of(material));
            if (begun.insert(&program).second) {
                begin_surface(program, inputs);
            }
            return program;
        };
    }

    // Without the occlusion map, which lacks blended surfaces.
    void draw_blended(const PassInputs& inputs) {
        if (geometry_.blend.empty()) {
            return;
        }
        gl_.Enable(GL_BLEND);
        gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        gl_.DepthMask(GL_FALSE);
        campus_.draw_blend(prepared_programs(inputs), Frustum(inputs.clip_campus), inputs.eye);
        gl_.DepthMask(GL_TRUE);
        gl_.Disable(GL_BLEND);
    }

    RenderSettings settings_;
    std::unique_ptr<GlContext> context_;
    GlFunctions gl_;
    CampusGeometry geometry_;
    GpuCampus campus_;
    GpuMesh figure_mesh_;
    std::size_t figure_indices_ = 0;
    ShaderProgram depth_;
    ShaderProgram masked_depth_;
    ShaderProgram sky_;
    ShadowMaps shadows_;
    SurfacePrograms surfaces_;
    AmbientOcclusionPass occlusion_;
    HierarchicalZ hierarchical_z_;
    GLuint no_vertices_ = 0;
    std::unique_ptr<RenderTarget> target_;
    std::unique_ptr<ChannelPass> channels_;  // created on first use
    std::unique_ptr<LinePass> lines_;        // likewise
};

Renderer::Renderer(std::span<const scene::Model> models, const RenderSettings& settings,
                   std::unique_ptr<GlContext> context)
    : impl_(std::make_unique<Impl>(models, settings, std::move(context))) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure,
                     std::span<const OverlayLine> lines) {
    return impl_->draw(view, width, height, figure, lines);
}

Channels Renderer::draw_channels(const Viewpoint& view, int width, int height, const ChannelChoice& choice,
                                 const std::optional<Figure>& figure) {
    return impl_->draw_channels(view, width, height, choice, figure);
}

const scene::Bounds& Renderer::bounds() const {
    return impl_->bounds();
}

}  // namespace campuswalk::engine::render
