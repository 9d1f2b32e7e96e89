// Writes intact files that need an encoder, for fuzz_models.py to damage: `write_packed_models FOLDER`.

#include <filesystem>

#include "tests/scene/import/gltf/packed_meshes.h"

using namespace campuswalk;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
    const support::TemporaryFolder folder;
    const scene::test::GridMesh grid = scene::test::grid_mesh(12);
    scene::test::draco_gltf(grid).write_glb(folder, "draco.glb");
    scene::test::meshopt_gltf(grid).write_glb(folder, "meshopt.glb");
    std::filesystem::create_directories(argv[1]);
    for (const char* name : {"draco.glb", "meshopt.glb"}) {
        std::filesystem::copy_file(folder.path() / name, std::filesystem::path(argv[1]) / name,
                                   std::filesystem::copy_options::overwrite_existing);
    }
    return 0;
}
