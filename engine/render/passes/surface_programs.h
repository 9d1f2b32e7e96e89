#pragma once

#include <compare>
#include <map>
#include <string>
#include <string_view>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// What a surface's program must be able to do. llvmpipe pays for all that a program has, used or not, so
/// each surface gets a program with just what its material needs.
struct SurfaceKind {
    scene::AlphaMode alpha = scene::AlphaMode::opaque;
    bool unlit = false;
    bool glow_map = false;    ///< an emissive texture
    bool normal_map = false;  ///< bumps
    bool shiny = false;       ///< metal, or smooth enough to mirror

    auto operator<=>(const SurfaceKind&) const = default;
};

SurfaceKind kind_of(const scene::Material& material);

/// The programs that draw a campus' surfaces. Lives as long as its context.
class SurfacePrograms {
public:
    /// `shadows`, `occlusion`: whether there are such maps at all.
    /// `constants`: of the light and the shadow maps.
    SurfacePrograms(const GlFunctions& gl, bool shadows, bool occlusion, std::string_view constants)
        : gl_(gl), shadows_(shadows), occlusion_(occlusion), constants_(constants) {}

    /// Compiled when it is first asked for.
    const ShaderProgram& of(const SurfaceKind& kind);

private:
    const GlFunctions& gl_;
    bool shadows_;
    bool occlusion_;
    std::string constants_;
    std::map<SurfaceKind, ShaderProgram> programs_;
};

}  // namespace campuswalk::engine::render
