// Reads files as responses of the import helper, and uses the models as a campus does: `read_responses FILE…`
// prints one line per file, "accepted" or why it was refused.

#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "scene/campus/bake_mesh.h"
#include "scene/campus/node_selection.h"
#include "scene/import/helper/import_process.h"

using namespace campuswalk;

namespace {

void use(const std::vector<scene::Model>& models) {
    const scene::Model& model = models.front();
    std::size_t texels = 0;
    for (const scene::Texture& texture : model.textures) {
        for (const std::uint8_t value : texture.rgba) {
            texels += value;
        }
    }
    std::vector<scene::NodeRef> all;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].parent < 0) {
            all.push_back({0, n});
        }
    }
    scene::BakedMesh baked = scene::bake_mesh(scene::gather_geometry(models, {all, {}}));
    const std::size_t triangles = baked.mesh.triangles.size();
    if (triangles > 0) {
        const collision::MeshCollider collider(std::move(baked.mesh));
        std::printf("accepted: %zu triangles, %zu, %d\n", triangles, texels, collider.closed_parts().empty());
    } else {
        std::printf("accepted: no triangle\n");
    }
}

void read_response(const char* file) {
    scene::SceneFile request;
    request.file = "response.glb";
    request.path = file;
    try {
        const scene::Importer importer = scene::import_in_process({"/bin/cat", {file}});
        use({importer(request, scene::EmptyModel::accept).model});
    } catch (const scene::InputError& error) {
        std::printf("refused: %s\n", error.what());
    } catch (const std::invalid_argument& error) {
        // Too far away for a collider, which a campus reports, too.
        std::printf("refused: %s\n", error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const char* file : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
        read_response(file);
        std::fflush(stdout);
    }
    return 0;
}
