#include "scene/import/import_model.h"

#include <memory>
#include <new>
#include <stdexcept>

#include "scene/import/assimp_source.h"
#include "scene/import/build_model.h"
#include "scene/import/gltf/gltf_source.h"
#include "scene/import/model_formats.h"

namespace campuswalk::scene {
namespace {

std::unique_ptr<ModelSource> open_source(const SceneFile& file) {
    check_readable(file);
    switch (reader_for(file)) {
        case Reader::gltf:
            return std::make_unique<gltf::GltfSource>(file);
        case Reader::assimp:
            break;
    }
    return std::make_unique<AssimpSource>(file);
}

}  // namespace

Model import_model(const SceneFile& file, std::vector<Diagnostic>& warnings, EmptyModel if_empty) {
    try {
        return build_model(*open_source(file), file, warnings, if_empty);
    } catch (const std::bad_alloc&) {
        throw InputError(file.mark, "bad-model",
                         "'" + file.file + "' needs more memory than there is; simplify or split it");
    } catch (const std::length_error&) {
        throw InputError(file.mark, "bad-model", "'" + file.file + "' asks for a size that can't be");
    }
}

}  // namespace campuswalk::scene
