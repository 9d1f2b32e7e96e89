#include "tests/benchmarks/demo_mesh.h"

#include <filesystem>
#include <vector>

#include "scene/bake_mesh.h"
#include "scene/import/import_model.h"
#include "scene/node_selection.h"

namespace campuswalk::bench {

collision::MeshCollider load_demo_mesh() {
    std::vector<scene::Model> models;
    std::vector<scene::Diagnostic> warnings;
    for (const char* name : {"ground.glb", "buildings.glb", "vegetation.glb", "furniture.glb"}) {
        scene::SceneFile file;
        file.file = name;
        file.path = std::filesystem::path(CAMPUSWALK_DEMO) / name;
        models.push_back(scene::import_model(file, warnings));
    }
    std::vector<scene::NodeRef> roots;
    for (std::size_t model = 0; model < models.size(); ++model) {
        for (std::size_t node = 0; node < models[model].nodes.size(); ++node) {
            if (models[model].nodes[node].parent < 0) {
                roots.push_back({model, node});
            }
        }
    }
    return collision::MeshCollider(scene::bake_mesh(scene::gather_geometry(models, roots)).mesh);
}

}  // namespace campuswalk::bench
