#include "tools/campuswalk/loading/model_importer.h"

#include "scene/import/helper/import_process.h"
#include "scene/import/helper/serve_import.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

scene::Importer model_importer() {
    // This program, even if its file has been replaced meanwhile.
    return scene::import_in_process({"/proc/self/exe", {scene::kImportHelperArgument}});
}

scene::ImportedModel read_model(const scene::SceneFile& file, scene::EmptyModel empty) {
    return load_model(file, empty, model_importer(), model_cache()).imported;
}

}  // namespace campuswalk::tools
