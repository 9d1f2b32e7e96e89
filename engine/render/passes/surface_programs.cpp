#include "engine/render/passes/surface_programs.h"

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

// On rougher dielectrics specular reflection is indistinguishable from ambient light.
constexpr float kMaxSpecularRoughness = 0.5F;

std::string defines_of(const SurfaceKind& kind, bool shadows, bool occlusion) {
    std::string defines;
    const auto define = [&](bool enabled, std::string_view name) {
        if (enabled) {
            defines.append("#define ").append(name).append("\n");
        }
    };
    define(kind.alpha == scene::AlphaMode::mask, "CUTOUT");
    define(kind.alpha == scene::AlphaMode::blend, "SEE_THROUGH");
    define(kind.unlit, "UNLIT");
    define(kind.emissive_map, "EMISSIVE_MAP");
    define(kind.normal_map, "NORMAL_MAP");
    define(kind.specular, "SPECULAR");
    define(!shadows, "NO_SHADOWS");
    // Blended surfaces aren't in the map; what is behind them is.
    define(occlusion && kind.alpha != scene::AlphaMode::blend, "OCCLUSION");
    return defines;
}

}  // namespace

SurfaceKind kind_of(const scene::Material& material) {
    SurfaceKind kind;
    kind.alpha = material.alpha_mode;
    kind.unlit = material.unlit;
    if (!material.unlit) {
        kind.emissive_map = material.emissive_texture.has_value();
        kind.normal_map = material.normal_texture.has_value();
        // Glass has reflections of its own, whatever its material says.
        kind.specular = material.alpha_mode != scene::AlphaMode::blend &&
                        (material.metallic > 0.0F || material.roughness < kMaxSpecularRoughness);
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
                                {shaders::kVersion, defines, constants_, shaders::kSkyChunk,
                                 shaders::kSrgbChunk, shaders::kShadowChunk, shaders::kSurfaceFragment});
    return programs_.emplace(kind, program).first->second;
}

}  // namespace campuswalk::engine::render
