#include "scene/import/import_model.h"

#include <memory>
#include <new>
#include <stdexcept>

#include "scene/import/assimp/assimp_source.h"
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

ImportedModel import_model(const SceneFile& file, EmptyModel if_empty) {
    try {
        ImportedModel imported;
        const std::unique_ptr<ModelSource> source = open_source(file);
        imported.model = build_model(*source, file, imported.warnings, if_empty);
        imported.requests = source->requests();
        return imported;
    } catch (const std::bad_alloc&) {
        throw InputError(file.mark, "bad-model",
                         "'" + file.file + "' needs more memory than is available; simplify or split it");
    } catch (const std::length_error&) {
        throw InputError(file.mark, "bad-model",
                         "'" + file.file + "' asks for an impossible allocation size");
    }
}

Model import_model(const SceneFile& file, std::vector<Diagnostic>& warnings, EmptyModel if_empty) {
    ImportedModel imported = import_model(file, if_empty);
    warnings.insert(warnings.end(), imported.warnings.begin(), imported.warnings.end());
    return std::move(imported.model);
}

}  // namespace campuswalk::scene
