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

/// The avatar to be drawn as a figure.
struct Figure {
    AvatarState avatar;
    AvatarProfile profile;
    double stride = 0.0;  ///< phase of its step, radians; 0 stands still
};

/// Draws models with sun, shadows and sky. The same models, settings and arguments give the same bytes.
/// All calls from one thread at a time.
class Renderer {
public:
    /// Uploads the models and draws the campus' shadow map, so the first image isn't the slow one. The
    /// models must outlive the renderer. Throws RenderError when the machine can't draw.
    explicit Renderer(std::span<const scene::Model> models, const RenderSettings& settings = {},
                      std::unique_ptr<GlContext> context = make_gl_context(RenderingBackend::automatic));
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// An image of `width` x `height` pixels. Throws RenderError for a size that can't be drawn.
    /// `lines` go over it.
    Image draw(const Viewpoint& view, int width, int height, const std::optional<Figure>& figure = {},
               std::span<const OverlayLine> lines = {});

    /// What the same image shows in numbers, as far as `choice` asks for it. Throws RenderError likewise.
    Channels draw_channels(const Viewpoint& view, int width, int height, const ChannelChoice& choice,
                           const std::optional<Figure>& figure = {});

    /// Of all models together.
    const scene::Bounds& bounds() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace campuswalk::engine::render
