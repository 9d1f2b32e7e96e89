#pragma once

#include <cstddef>

#include <GL/glcorearb.h>

#include "engine/render/gl/gl_context.h"

namespace campuswalk::engine::render {

/// X(TYPE, Name) for every GL function in use: PFNGL<TYPE>PROC and "gl<Name>".
#define CAMPUSWALK_GL_FUNCTIONS(X)                                          \
    X(ACTIVETEXTURE, ActiveTexture)                                         \
    X(ATTACHSHADER, AttachShader)                                           \
    X(BINDBUFFER, BindBuffer)                                               \
    X(BINDFRAMEBUFFER, BindFramebuffer)                                     \
    X(BINDRENDERBUFFER, BindRenderbuffer)                                   \
    X(BINDTEXTURE, BindTexture)                                             \
    X(BINDVERTEXARRAY, BindVertexArray)                                     \
    X(BLENDFUNCSEPARATE, BlendFuncSeparate)                                 \
    X(BLITFRAMEBUFFER, BlitFramebuffer)                                     \
    X(BUFFERDATA, BufferData)                                               \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                       \
    X(CLEAR, Clear)                                                         \
    X(CLEARBUFFERFV, ClearBufferfv)                                         \
    X(CLEARBUFFERUIV, ClearBufferuiv)                                       \
    X(CLEARCOLOR, ClearColor)                                               \
    X(CLEARDEPTH, ClearDepth)                                               \
    X(CLIPCONTROL, ClipControl)                                             \
    X(COMPILESHADER, CompileShader)                                         \
    X(CREATEPROGRAM, CreateProgram)                                         \
    X(CREATESHADER, CreateShader)                                           \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                               \
    X(DELETERENDERBUFFERS, DeleteRenderbuffers)                             \
    X(DELETETEXTURES, DeleteTextures)                                       \
    X(DEPTHFUNC, DepthFunc)                                                 \
    X(DEPTHMASK, DepthMask)                                                 \
    X(DISABLE, Disable)                                                     \
    X(DRAWARRAYS, DrawArrays)                                               \
    X(DRAWBUFFERS, DrawBuffers)                                             \
    X(DRAWELEMENTS, DrawElements)                                           \
    X(DRAWELEMENTSINSTANCEDBASEINSTANCE, DrawElementsInstancedBaseInstance) \
    X(ENABLE, Enable)                                                       \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                     \
    X(FLUSH, Flush)                                                         \
    X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)                     \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                           \
    X(FRONTFACE, FrontFace)                                                 \
    X(GENBUFFERS, GenBuffers)                                               \
    X(GENERATEMIPMAP, GenerateMipmap)                                       \
    X(GENFRAMEBUFFERS, GenFramebuffers)                                     \
    X(GENRENDERBUFFERS, GenRenderbuffers)                                   \
    X(GENTEXTURES, GenTextures)                                             \
    X(GENVERTEXARRAYS, GenVertexArrays)                                     \
    X(GETERROR, GetError)                                                   \
    X(GETINTEGERV, GetIntegerv)                                             \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                 \
    X(GETPROGRAMIV, GetProgramiv)                                           \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                                   \
    X(GETSHADERIV, GetShaderiv)                                             \
    X(GETUNIFORMLOCATION, GetUniformLocation)                               \
    X(LINKPROGRAM, LinkProgram)                                             \
    X(PIXELSTOREI, PixelStorei)                                             \
    X(POLYGONOFFSET, PolygonOffset)                                         \
    X(READBUFFER, ReadBuffer)                                               \
    X(READPIXELS, ReadPixels)                                               \
    X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample)       \
    X(SCISSOR, Scissor)                                                     \
    X(SHADERSOURCE, ShaderSource)                                           \
    X(TEXIMAGE2D, TexImage2D)                                               \
    X(TEXIMAGE2DMULTISAMPLE, TexImage2DMultisample)                         \
    X(TEXPARAMETERI, TexParameteri)                                         \
    X(UNIFORM1F, Uniform1f)                                                 \
    X(UNIFORM1I, Uniform1i)                                                 \
    X(UNIFORM2F, Uniform2f)                                                 \
    X(UNIFORM2I, Uniform2i)                                                 \
    X(UNIFORM3F, Uniform3f)                                                 \
    X(UNIFORM4F, Uniform4f)                                                 \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)                                   \
    X(USEPROGRAM, UseProgram)                                               \
    X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)                             \
    X(VERTEXATTRIBIPOINTER, VertexAttribIPointer)                           \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)                             \
    X(VIEWPORT, Viewport)

/// GL entry points, loaded once per context: `gl.Clear(…)`.
struct GlFunctions {
#define CAMPUSWALK_DECLARE(type, name) PFNGL##type##PROC name = nullptr;
    CAMPUSWALK_GL_FUNCTIONS(CAMPUSWALK_DECLARE)
#undef CAMPUSWALK_DECLARE
};

/// An offset into the bound buffer in the form that GL expects.
inline const void* buffer_offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): GL's interface
}

/// Throws RenderError that names the first function that the driver lacks.
GlFunctions load_gl_functions(const GlContext& context);

}  // namespace campuswalk::engine::render
