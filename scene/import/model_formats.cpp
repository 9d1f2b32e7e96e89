#include "scene/import/model_formats.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "scene/base/why_unreadable.h"
#include "scene/import/source/ply_header.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {
namespace {

struct KnownFormat {
    std::string_view extension;
    Reader reader;
};

constexpr std::array<KnownFormat, 9> kFormats = {{{".gltf", Reader::gltf},
                                                  {".glb", Reader::gltf},
                                                  {".obj", Reader::assimp},
                                                  {".fbx", Reader::assimp},
                                                  {".dae", Reader::assimp},
                                                  {".stl", Reader::assimp},
                                                  {".ply", Reader::assimp},
                                                  {".off", Reader::assimp},
                                                  {".3ds", Reader::assimp}}};

struct RefusedFormat {
    std::string_view extension;
    std::string_view advice;
};

constexpr std::array<RefusedFormat, 6> kRefused = {{
    {".ifc",
     "IFC is not supported: its importer crashes on real files; convert it to glTF (IfcConvert, Blender)"},
    {".3mf", "3MF is not supported: its importer crashes on damaged files; convert it to glTF or OBJ"},
    {".blend", ".blend files are not supported; export glTF from Blender"},
    {".skp", ".skp files are not supported; export COLLADA or glTF from SketchUp"},
    {".usd", "USD is not supported; convert it to glTF (Blender)"},
    {".usdz", "USD is not supported; convert it to glTF (Blender)"},
}};

}  // namespace

Reader reader_for(const SceneFile& file) {
    const std::string extension = lower_case(file.path.extension().string());
    if (const auto* known = std::ranges::find(kFormats, extension, &KnownFormat::extension);
        known != kFormats.end()) {
        return known->reader;
    }
    if (const auto* refused = std::ranges::find(kRefused, extension, &RefusedFormat::extension);
        refused != kRefused.end()) {
        throw InputError(file.mark, "bad-model", std::string(refused->advice));
    }
    std::string names;
    for (const KnownFormat& format : kFormats) {
        names += names.empty() ? "" : ", ";
        names += format.extension;
    }
    throw InputError(file.mark, "bad-model",
                     "'" + file.file + "' is not in a supported format (" + names + "); convert it to glTF");
}

void check_readable(const SceneFile& file) {
    // The full path: users may not expect that it is relative to the campus file.
    const std::string shown = "'" + file.path.lexically_normal().generic_string() + "': ";
    if (const std::string why = why_unreadable(file.path); !why.empty()) {
        throw InputError(file.mark, "missing-file", shown + why);
    }
    if (lower_case(file.path.extension().string()) == ".ply") {
        std::ifstream in(file.path, std::ios::binary);
        if (const std::string fault = ply_fault(in); !fault.empty()) {
            throw InputError(
                file.mark, "bad-model",
                "'" + file.file + "' can't be read as a model: " + fault + "; export or copy it again");
        }
    }
}

}  // namespace campuswalk::scene
