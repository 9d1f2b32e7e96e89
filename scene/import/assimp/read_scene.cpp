#include "scene/import/assimp/read_scene.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace campuswalk::scene {
namespace {

void configure(Assimp::Importer& importer, ColladaNames names) {
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, names == ColladaNames::names);
    // Else geometric transforms move children, and PostRotation isn't inverted: see convert_nodes.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
}

struct FaceCheck {
    bool indices_in_range = true;  ///< triangulation does not check them
    bool has_polygons = false;
};

FaceCheck check_faces(const aiScene& scene) {
    FaceCheck check;
    for (unsigned int m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            check.has_polygons = check.has_polygons || face.mNumIndices > 3;
            for (unsigned int k = 0; k < face.mNumIndices; ++k) {
                check.indices_in_range = check.indices_in_range && face.mIndices[k] < mesh.mNumVertices;
            }
        }
    }
    return check;
}

[[noreturn]] void throw_bad_model(const SceneFile& file, const ReadScene& read, std::string words) {
    while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) {
        words.pop_back();
    }
    if (words.find("OBJ-file is too small") != std::string::npos) {
        throw InputError(file.mark, "empty-mesh", "'" + file.file + "' has no triangles");
    }
    if (!read.files->fault().empty()) {
        throw InputError(
            file.mark, "bad-model",
            "'" + file.file + "' can't be read as a model: " + read.files->fault() + "; export it again");
    }
    std::string message = "'" + file.file + "' can't be read as a model: " + words;
    for (const std::string& name : read.files->refused()) {
        if (words.find(name) == std::string::npos) {
            message += "; '" + name + "' is missing or outside the scene's folder";
        }
    }
    throw InputError(file.mark, "bad-model", message);
}

}  // namespace

void read_scene(const SceneFile& file, const SceneFolder& folder, ReadScene& out, ColladaNames names) {
    configure(out.importer, names);
    out.files = new ConfinedFiles(folder, file.metres_per_unit * file.scale);
    out.importer.SetIOHandler(out.files);
    try {
        out.scene = out.importer.ReadFile(file.path.filename().string(), 0);
        if (out.scene == nullptr) {
            throw_bad_model(file, out, out.importer.GetErrorString());
        }
        const FaceCheck faces = check_faces(*out.scene);
        if (!faces.indices_in_range) {
            throw_bad_model(file, out, "a face refers to a vertex that does not exist");
        }
        if (faces.has_polygons) {
            out.scene = out.importer.ApplyPostProcessing(aiProcess_Triangulate);
        }
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw_bad_model(file, out, error.what());
    }
    if (out.scene == nullptr || out.scene->mRootNode == nullptr) {
        throw_bad_model(file, out, "it is empty");
    }
}

}  // namespace campuswalk::scene
