#pragma once

#include "scene/import/assimp/read_scene.h"
#include "scene/import/source/model_source.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// OBJ, FBX, COLLADA, STL, PLY and the other formats that assimp reads.
class AssimpSource final : public ModelSource {
public:
    /// Throws InputError missing-file or bad-model.
    explicit AssimpSource(const SceneFile& file);

    NodeTree nodes() override;
    const std::vector<SourceMaterial>& materials() override { return materials_; }
    RawMesh mesh(std::size_t number) override;
    std::optional<DecodedImage> load_image(const TextureReference& reference, std::string& reason) override;
    bool flat_normals() const override { return false; }
    std::optional<GeographicPlace> geographic() const override;
    void add_warnings(DiagnosticList& warnings) override;
    std::vector<FileRequest> requests() const override { return folder_.requests(); }

private:
    void replace_generated_names(NodeTree& tree) const;
    bool is_obj() const;

    const SceneFile& file_;
    SceneFolder folder_;
    ReadScene read_;
    std::vector<SourceMaterial> materials_;
};

}  // namespace campuswalk::scene
