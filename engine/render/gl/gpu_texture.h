#pragma once

#include "engine/render/gl/gl_functions.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// Uploads an sRGB texture with its chain of smaller copies. Shaders get it as it is encoded, and decode it
/// (kSrgbChunk).
GLuint upload_color_texture(const GlFunctions& gl, const scene::Texture& texture);
/// Likewise one whose alpha is tested against `alpha_cutoff` when drawn: the smaller copies keep the share of
/// the texture that passes, or trees would lose their leaves with distance.
GLuint upload_cutout_texture(const GlFunctions& gl, const scene::Texture& texture, float alpha_cutoff);
/// Likewise one of numbers, not colours: bumps, roughness.
GLuint upload_data_texture(const GlFunctions& gl, const scene::Texture& texture);

/// All white and opaque, for materials without a texture. With a smaller copy like any other texture: for one
/// without, the driver would compile the shaders again.
GLuint upload_white_texture(const GlFunctions& gl);

}  // namespace campuswalk::engine::render
