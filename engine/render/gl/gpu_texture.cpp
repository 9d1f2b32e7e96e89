#include "engine/render/gl/gpu_texture.h"

#include <array>

#include "engine/render/gl/render_error.h"
#include "engine/render/image/mip_chain.h"

namespace campuswalk::engine::render {
namespace {

GLint gl_wrap(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat:
            break;
        case scene::Wrap::clamp:
            return GL_CLAMP_TO_EDGE;
        case scene::Wrap::mirror:
            return GL_MIRRORED_REPEAT;
    }
    return GL_REPEAT;
}

GLuint make_texture(const GlFunctions& gl, const scene::TextureWrap& wrap) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, gl_wrap(wrap.u));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, gl_wrap(wrap.v));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

void upload_level(const GlFunctions& gl, int level, int width, int height, const std::uint8_t* rgba) {
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

// Mip levels are averaged in linear light, but shaders decode after filtering: the driver would decode each
// of a lookup's eight texels.
void skip_srgb_decode(const GlFunctions& gl) {
    while (gl.GetError() != GL_NO_ERROR) {
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
    if (gl.GetError() != GL_NO_ERROR) {
        throw RenderError(
            "the OpenGL driver has no EXT_texture_sRGB_decode: snapshots need it (any Mesa since 2011)");
    }
}

}  // namespace

GLuint upload_color_texture(const GlFunctions& gl, const scene::Texture& texture) {
    const GLuint name = make_texture(gl, texture.wrap);
    upload_level(gl, 0, texture.width, texture.height, texture.rgba.data());
    gl.GenerateMipmap(GL_TEXTURE_2D);
    skip_srgb_decode(gl);  // after mip generation, which has to average linear light
    return name;
}

GLuint upload_data_texture(const GlFunctions& gl, const scene::Texture& texture) {
    const GLuint name = make_texture(gl, texture.wrap);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width, texture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texture.rgba.data());
    gl.GenerateMipmap(GL_TEXTURE_2D);
    return name;
}

GLuint upload_cutout_texture(const GlFunctions& gl, const scene::Texture& texture, float alpha_cutoff) {
    const GLuint name = make_texture(gl, texture.wrap);
    upload_level(gl, 0, texture.width, texture.height, texture.rgba.data());
    skip_srgb_decode(gl);
    int level = 0;
    for (const MipLevel& mip : cutout_mip_chain(texture, alpha_cutoff)) {
        upload_level(gl, ++level, mip.width, mip.height, mip.rgba.data());
    }
    return name;
}

GLuint upload_white_texture(const GlFunctions& gl) {
    const GLuint name = make_texture(gl, {});
    std::array<std::uint8_t, 16> white{};
    white.fill(255);
    skip_srgb_decode(gl);
    upload_level(gl, 0, 2, 2, white.data());
    upload_level(gl, 1, 1, 1, white.data());
    return name;
}

}  // namespace campuswalk::engine::render
