#pragma once

#include <memory>
#include <optional>
#include <span>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/camera.h"
#include "engine/render/geometry/overlay_lines.h"
#include "engine/render/gl/gl_context.h"
#include "engine/render/image/channels.h"
#include "engine/render/image/image.h"
#include "engine/render/passes/render_settings.h"
#include "engine/script/avatar.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// The avatar as it is drawn.
struct Figure {
    AvatarState avatar;
    AvatarProfile profile;
    double stride = 0.0;  ///< phase of the gait, radians; 0 stands still
};

/// Draws models with sun, shadows and sky. The same models, settings and arguments give the same bytes. Not
/// thread-safe.
class Renderer {
public:
    /// Uploads the models and draws the far shadow map. The models must outlive the renderer. Throws
    /// RenderError if no OpenGL context can be made.
    explicit Renderer(std::span<const scene::Model> models, const RenderSettings& settings = {},
                      std::unique_ptr<GlContext> context = make_gl_context(RenderingBackend::automatic));
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws an image of `width` x `height` pixels with `lines` over it. Throws RenderError if the driver
    /// can't render this size.
    Image draw(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure = {},
               std::span<const OverlayLine> lines = {});

    /// The channels of the same image that `choice` selects. Throws like `draw`.
    Channels draw_channels(const Viewpoint& view, int width, int height, const ChannelChoice& choice,
                           const std::optional<Figure>& figure = {});

    /// Bounds of all models, world frame.
    const scene::Bounds& bounds() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace campuswalk::engine::render
