#include "engine/render/passes/surface_programs.h"

#include <string>

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

// Duller than this, what a surface mirrors can't be told from the light all around.
constexpr float kDull = 0.5F;

std::string defines_of(const SurfaceKind& kind, bool shadows, bool occlusion) {
    std::string defines;
    const auto define = [&](bool wanted, std::string_view name) {
        if (wanted) {
            defines.append("#define ").append(name).append("\n");
        }
    };
    define(kind.alpha == scene::AlphaMode::mask, "CUTOUT");
    define(kind.alpha == scene::AlphaMode::blend, "SEE_THROUGH");
    define(kind.unlit, "UNLIT");
    define(kind.glow_map, "GLOW_MAP");
    define(kind.normal_map, "NORMAL_MAP");
    define(kind.shiny, "SHINY");
    define(!shadows, "NO_SHADOWS");
    // What is behind a pane is in the map, the pane isn't.
    define(occlusion && kind.alpha != scene::AlphaMode::blend, "OCCLUSION");
    return defines;
}

}  // namespace

SurfaceKind kind_of(const scene::Material& material) {
    SurfaceKind kind;
    kind.alpha = material.alpha_mode;
    kind.unlit = material.unlit;
    if (!material.unlit) {
        kind.glow_map = material.emissive_texture.has_value();
        kind.normal_map = material.normal_texture.has_value();
        // A pane mirrors by itself, whatever its material says.
        kind.shiny = material.alpha_mode != scene::AlphaMode::blend &&
                     (material.metallic > 0.0F || material.roughness < kDull);
    }
    return kind;
}

const ShaderProgram& SurfacePrograms::of(const SurfaceKind& kind) {
    const auto known = programs_.find(kind);
    if (known != programs_.end()) {
        return known->second;
    }
    const std::string defines = defines_of(kind, shadows_, occlusion_);
    const ShaderProgram program(gl_, "surface",
                                {shaders::kVersion, shaders::kInstanceChunk, shaders::kSurfaceVertex},
                                {shaders::kVersion, defines, constants_, shaders::kAirChunk,
                                 shaders::kSrgbChunk, shaders::kShadowChunk, shaders::kSurfaceFragment});
    return programs_.emplace(kind, program).first->second;
}

}  // namespace campuswalk::engine::render
