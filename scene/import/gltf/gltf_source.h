#pragma once

#include <memory>

#include "scene/import/source/model_source.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene::gltf {

/// glTF 2.0 and GLB, with Draco, meshopt, instancing, texture transforms and WebP.
class GltfSource final : public ModelSource {
public:
    /// Throws InputError bad-model.
    explicit GltfSource(const SceneFile& file);
    ~GltfSource() override;

    NodeTree nodes() override;
    const std::vector<SourceMaterial>& materials() override { return materials_; }
    RawMesh mesh(std::size_t number) override;
    std::optional<DecodedImage> load_image(const TextureReference& reference, std::string& reason) override;
    bool flat_normals() const override { return true; }
    std::optional<GeographicPlace> geographic() const override;
    void add_warnings(DiagnosticList& warnings) override;
    std::vector<FileRequest> requests() const override;

private:
    struct Parts;
    template <typename Call>
    auto reading(const Call& call) const;
    std::optional<DecodedImage> embedded_image(std::size_t image, std::string& reason);

    const SceneFile& file_;
    std::unique_ptr<Parts> parts_;
    std::vector<SourceMaterial> materials_;
};

}  // namespace campuswalk::scene::gltf
