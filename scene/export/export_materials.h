#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/export/glb_buffers.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// The materials of several models as glTF has them, equal ones once, with their textures as WebP.
class ExportMaterials {
public:
    /// `models` and `buffers`, which get the images, must outlive it. `texture_size`: pixels a side at most.
    ExportMaterials(std::span<const Model> models, int texture_size, GlbBuffers& buffers);

    /// The number of a material, which is added if it is new.
    std::size_t number_of(std::size_t model, MaterialIndex material);

    /// The members "materials" and, if there are any, "images", "samplers" and "textures".
    /// `first_image`: see GlbBuffers::Finished.
    std::string json(std::size_t first_image) const;

private:
    std::string json_of(std::size_t model, const Material& material);
    std::size_t texture_of(std::size_t model, TextureIndex texture);
    std::size_t image_of(const Texture& texture);

    std::span<const Model> models_;
    int texture_size_;
    GlbBuffers& buffers_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_;  ///< by model and material
    std::map<std::string, std::size_t> numbers_;                        ///< by the material's JSON
    std::vector<std::string> materials_;
    std::map<std::pair<std::size_t, TextureWrap>, std::size_t> textures_;  ///< by image
    std::vector<std::pair<std::size_t, TextureWrap>> texture_list_;
    std::vector<TextureWrap> samplers_ = {{Wrap::repeat, Wrap::repeat}, {Wrap::clamp, Wrap::clamp}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_images_;  ///< by model and texture
    std::map<std::string, std::size_t> images_;                                ///< by the file's bytes
};

}  // namespace campuswalk::scene
