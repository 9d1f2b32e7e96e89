#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

/// See tools/campuswalk_bench/import/import_cases.h.
extern "C" unsigned long import_with_peer(const char* file, bool join) {
    Assimp::Importer importer;
    const unsigned int steps = join ? aiProcess_GenNormals | aiProcess_JoinIdenticalVertices : 0U;
    const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | steps);
    unsigned long triangles = 0;
    for (unsigned int i = 0; scene != nullptr && i < scene->mNumMeshes; ++i) {
        triangles += scene->mMeshes[i]->mNumFaces;
    }
    return triangles;
}
