#pragma once

#include <compare>
#include <map>
#include <string>
#include <string_view>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

/// The features of a surface program. llvmpipe pays for everything a program contains, used or not, so each
/// material gets the variant with just what it needs.
struct SurfaceKind {
    scene::AlphaMode alpha = scene::AlphaMode::opaque;
    bool unlit = false;
    bool emissive_map = false;  ///< an emissive texture
    bool normal_map = false;    ///< a normal texture
    bool specular = false;      ///< metal, or smooth enough to mirror

    auto operator<=>(const SurfaceKind&) const = default;
};

SurfaceKind kind_of(const scene::Material& material);

/// The surface program variants. Must not outlive its context.
class SurfacePrograms {
public:
    /// `shadows`, `occlusion`: whether these maps exist. `constants`: of the light and the shadow maps.
    SurfacePrograms(const GlFunctions& gl, bool shadows, bool occlusion, std::string_view constants)
        : gl_(gl), shadows_(shadows), occlusion_(occlusion), constants_(constants) {}

    /// Compiles the variant on first use.
    const ShaderProgram& of(const SurfaceKind& kind);

private:
    const GlFunctions& gl_;
    bool shadows_;
    bool occlusion_;
    std::string constants_;
    std::map<SurfaceKind, ShaderProgram> programs_;
};

}  // namespace campuswalk::engine::render
