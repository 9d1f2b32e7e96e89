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

// Around the campus on a plan, linear: the grey of paper.
const Eigen::Vector3d kBackground(0.60, 0.61, 0.59);

// Shares of open sky: with less the camera is in a room, with more it is outside.
constexpr double kInside = 0.06;
constexpr double kOutside = 0.42;

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
               {shaders::kVersion, light_constants(settings_).text(), shaders::kAirChunk, shaders::kSrgbChunk,
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

    // Members free their GL objects by number: those of this context, not of whichever is current.
    ~Impl() {
        try {
            context_->make_current();
        } catch (const RenderError&) {
            // The driver has lost the context, and its objects with it.
        }
    }

    Image draw(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure,
               std::span<const OverlayLine> lines) {
        context_->make_current();
        if (settings_.supersampling > 1) {
            RenderTarget::check_size(gl_, width, height, 2);
            return halved(draw_once(view, 2 * width, 2 * height, figure, lines));
        }
        Image image = draw_once(view, width, height, figure, lines);
        return settings_.fxaa ? apply_fxaa(image) : std::move(image);
    }

    Image draw_once(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure,
                    std::span<const OverlayLine> lines) {
        fit_target(width, height);
        occlusion_.fit(width, height);
        Frame frame;
        frame.eye = view.position - geometry_.origin;
        frame.clip_campus = clip_from_campus(view, static_cast<double>(width) / height);
        frame.perspective = view.projection == Projection::perspective;
        frame.room_share = room_share(frame);
        frame.figure = figure ? upload(*figure) : nullptr;
        frame.near_shadows = settings_.shadows && frame.perspective;
        frame.occlusion = frame.perspective && settings_.ambient_occlusion_radius > 0.0;
        if (frame.near_shadows) {
            shadows_.draw_near(frame.eye, -view.R_world_camera.col(2), frame.figure, figure_indices_);
        }
        if (frame.occlusion) {
            occlusion_.draw(campus_, frame.figure, figure_indices_, view, frame.clip_campus,
                            settings_.ambient_occlusion_radius);
        } else {
            occlusion_.clear_to_unoccluded();
        }
        target_->begin(kBackground);
        // What covers a pixel is written as its byte; what is mixed with what is there, as light.
        gl_.Disable(GL_FRAMEBUFFER_SRGB);
        draw_solid(frame);
        if (frame.perspective) {
            draw_sky(view, width, height);
        }
        gl_.Enable(GL_FRAMEBUFFER_SRGB);
        draw_see_through(frame);
        if (!lines.empty()) {
            if (!lines_) {
                lines_ = std::make_unique<LinePass>(gl_);
            }
            lines_->draw(lines, frame.clip_campus, geometry_.origin, width, height);
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
    struct Frame {
        Eigen::Vector3d eye = Eigen::Vector3d::Zero();  // campus frame
        double room_share = 0.0;                        // 1 in a room
        Eigen::Matrix4d clip_campus = Eigen::Matrix4d::Identity();
        bool perspective = true;
        bool near_shadows = false;
        bool occlusion = false;
        const GpuMesh* figure = nullptr;
    };

    // Depth from 1 (near) to 0 (far) needs GL's clip space changed before anything is drawn.
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

    double room_share(const Frame& frame) const {
        if (!frame.perspective) {
            return 0.0;
        }
        const double open = open_sky(geometry_, frame.eye);
        return std::clamp((kOutside - open) / (kOutside - kInside), 0.0, 1.0);
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

    void begin_surfaces(const ShaderProgram& surface, const Frame& frame) const {
        surface.use();
        surface.set("clip_campus", frame.clip_campus);
        surface.set("eye", frame.eye);
        surface.set("room_share", frame.room_share);
        const bool fog = frame.perspective && settings_.fog_distance > 0.0;
        surface.set("fog_density", fog ? 1.0 / settings_.fog_distance : 0.0);
        surface.set("base_color_map", 0);
        shadows_.bind(surface, frame.near_shadows);
        occlusion_.bind(surface);
    }

    void draw_solid(const Frame& frame) {
        const Frustum frustum(frame.clip_campus);
        HierarchicalZ* depth = settings_.occlusion_culling && frame.perspective ? &hierarchical_z_ : nullptr;
        if (depth != nullptr) {
            depth->begin(*target_, frame.clip_campus);
        }
        gl_.Disable(GL_BLEND);
        if (frame.figure != nullptr) {
            const ShaderProgram& plain = surfaces_.of({});
            begin_surfaces(plain, frame);
            campus_.set_plain_material(plain);
            frame.figure->bind();
            frame.figure->draw(0, figure_indices_);
        }
        const ProgramSelector program_of = prepared_programs(frame);
        campus_.draw_solid(program_of, scene::AlphaMode::opaque, frustum, frame.eye, depth);
        if (settings_.samples > 1) {
            gl_.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        }
        campus_.draw_solid(program_of, scene::AlphaMode::mask, frustum, frame.eye, depth);
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

    // Each with the frame's light, set when it is first asked for.
    ProgramSelector prepared_programs(const Frame& frame) {
        return [this, &frame, begun = std::set<const ShaderProgram*>()](
                   const scene::Material& material) mutable -> const ShaderProgram& {
            const ShaderProgram& program = surfaces_.of(kind_of(material));
            if (begun.insert(&program).second) {
                begin_surfaces(program, frame);
            }
            return program;
        };
    }

    // Without the occlusion map, which knows what is behind a pane but not the pane.
    void draw_see_through(const Frame& frame) {
        if (geometry_.blend.empty()) {
            return;
        }
        gl_.Enable(GL_BLEND);
        gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        gl_.DepthMask(GL_FALSE);
        campus_.draw_blend(prepared_programs(frame), Frustum(frame.clip_campus), frame.eye);
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
    std::unique_ptr<ChannelPass> channels_;  // none before the first is asked for
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
