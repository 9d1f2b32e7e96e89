#pragma once

#include "engine/render/gl/gl_functions.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// Uploads an sRGB texture with its mip levels. Samples are still encoded; shaders decode them (kSrgbChunk).
GLuint upload_color_texture(const GlFunctions& gl, const scene::Texture& texture);
/// Likewise for alpha testing against `alpha_cutoff`: mip levels preserve coverage, or trees would lose their
/// leaves in the distance.
GLuint upload_cutout_texture(const GlFunctions& gl, const scene::Texture& texture, float alpha_cutoff);
/// Likewise a texture of linear data: normals, roughness.
GLuint upload_data_texture(const GlFunctions& gl, const scene::Texture& texture);

/// Opaque white, for materials without a texture. Has mip levels like any other texture: without, the driver
/// would recompile the shaders.
GLuint upload_white_texture(const GlFunctions& gl);

}  // namespace campuswalk::engine::render
