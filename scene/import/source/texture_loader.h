#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/import/source/model_source.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// Decodes the textures that materials name, each once.
class TextureLoader {
public:
    explicit TextureLoader(ModelSource& source) : source_(source) {}

    /// nullopt when the image is missing or can't be decoded, with the reason in `reason`.
    std::optional<TextureIndex> load(const TextureReference& reference, std::string& reason);

    const Texture& texture(TextureIndex index) const { return textures_[index_of(index)]; }
    std::vector<Texture> take_textures() { return std::move(textures_); }

private:
    ModelSource& source_;
    std::vector<Texture> textures_;
    std::map<std::pair<std::string, bool>, TextureIndex> loaded_;  // by uri and wrap mode
};

/// Whether the image has holes: pixels that are clear and pixels that are solid.
bool has_cut_outs(const Texture& texture);

}  // namespace campuswalk::scene
