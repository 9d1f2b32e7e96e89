#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/import/convert_material.h"
#include "scene/import/scene_folder.h"
#include "scene/model.h"

struct aiScene;

namespace campuswalk::scene {

/// Decodes the textures that materials name, each once.
class TextureLoader {
public:
    TextureLoader(const aiScene& scene, SceneFolder folder) : scene_(scene), folder_(std::move(folder)) {}

    /// nullopt when the picture is missing or can't be decoded, with the reason in `reason`.
    std::optional<TextureIndex> load(const TextureReference& reference, std::string& reason);

    const Texture& texture(TextureIndex index) const { return textures_[index_of(index)]; }
    std::vector<Texture> take_textures() { return std::move(textures_); }

private:
    std::optional<Texture> decode(const TextureReference& reference, std::string& reason) const;

    const aiScene& scene_;
    SceneFolder folder_;
    std::vector<Texture> textures_;
    std::map<std::pair<std::string, bool>, TextureIndex> loaded_;  // by uri and wrap mode
};

/// Whether the picture has holes: pixels that are clear and pixels that are solid.
bool has_cut_outs(const Texture& texture);

}  // namespace campuswalk::scene
