#include "scene/import/read_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace campuswalk::scene {
namespace {

struct RefusedFormat {
    std::string_view extension;
    std::string_view cure;
};

// Formats whose importer in assimp 5.2.5 crashes on real files, which would take the program with it.
constexpr std::array<RefusedFormat, 2> kRefused = {{
    {".ifc", "IFC is not read: its importer crashes on real files; convert it to glTF (IfcConvert, Blender)"},
    {".3mf", "3MF is not read: its importer crashes on damaged files; convert it to glTF or OBJ"},
}};

void check_readable(const SceneFile& file) {
    std::error_code ignored;
    // With its folder: a campus' scenes are looked for beside it, which its reader may not have in mind.
    const std::string shown = "'" + file.path.lexically_normal().generic_string() + "': ";
    const auto refuse = [&](const char* why) { throw InputError(file.mark, "missing-file", shown + why); };
    if (!std::filesystem::exists(file.path, ignored)) {
        refuse("no such file; check the path");
    }
    if (!std::filesystem::is_regular_file(file.path, ignored)) {
        refuse("is not a file; name a model file");
    }
    if (!std::ifstream(file.path, std::ios::binary)) {
        refuse("cannot be read; check its permissions");
    }
}

void check_format(const SceneFile& file) {
    std::string extension = file.path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const RefusedFormat& refused : kRefused) {
        if (extension == refused.extension) {
            throw InputError(file.mark, "bad-model", std::string(refused.cure));
        }
    }
}

void configure(Assimp::Importer& importer, ColladaNames names) {
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, names == ColladaNames::names);
    // One node for one object, not a chain of seven `$AssimpFbx$` pivots.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
}

struct FaceCheck {
    bool indices_in_range = true;  ///< triangulation reads vertices by them without looking
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
        throw InputError(file.mark, "empty-mesh", "'" + file.file + "' has no triangle");
    }
    std::string message = "'" + file.file + "' is not a model that can be read: " + words;
    for (const std::string& name : read.files->refused()) {
        if (words.find(name) == std::string::npos) {
            message += "; '" + name + "' is missing or outside the scene's folder";
        }
    }
    throw InputError(file.mark, "bad-model", message);
}

}  // namespace

void read_scene(const SceneFile& file, ReadScene& out, ColladaNames names) {
    check_readable(file);
    check_format(file);
    configure(out.importer, names);
    out.files = new LockedFiles(SceneFolder(file.path));
    out.importer.SetIOHandler(out.files);
    try {
        out.scene = out.importer.ReadFile(file.path.filename().string(), 0);
        if (out.scene == nullptr) {
            throw_bad_model(file, out, out.importer.GetErrorString());
        }
        const FaceCheck faces = check_faces(*out.scene);
        if (!faces.indices_in_range) {
            throw_bad_model(file, out, "a face uses a vertex that is not there");
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
        throw_bad_model(file, out, "nothing is in it");
    }
}

}  // namespace campuswalk::scene
