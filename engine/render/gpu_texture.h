#pragma once

#include "engine/render/gl_functions.h"
#include "scene/model.h"

namespace campuswalk::engine::render {

/// Uploads an sRGB texture with its chain of smaller copies. With `cutout`, alpha is tested against
/// `alpha_cutoff` when drawn: the smaller copies then keep the share of the texture that passes, or trees
/// would lose their leaves with distance.
GLuint upload_texture(const GlFunctions& gl, const scene::Texture& texture, bool cutout, float alpha_cutoff);

/// All white and opaque, for materials without a texture. With a smaller copy like any other texture: for one
/// without, the driver would compile the shaders again.
GLuint upload_white(const GlFunctions& gl);

}  // namespace campuswalk::engine::render
