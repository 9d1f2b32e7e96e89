#include "scene/import/helper/serve_import.h"

#include <exception>

#include "scene/import/helper/helper_streams.h"
#include "scene/import/helper/import_protocol.h"
#include "scene/import/source/scene_folder.h"
#include "scene/model/model_file.h"

namespace campuswalk::scene {
namespace {

ImportedModel response_to(const ImportRequest& request) {
    try {
        return import_model(request.file, request.if_empty);
    } catch (const InputError& error) {
        return error_response(error);
    }
}

}  // namespace

int serve_import() {
    const std::vector<std::byte> bytes = read_helper_request();
    if (bytes.empty()) {
        return 2;
    }
    try {
        const ImportRequest request = read_request(bytes);
        limit_process(request.limits);
        enter_sandbox(SceneFolder(request.file).readable_paths(), request.sandbox);
        const ImportedModel response = response_to(request);
        ArchiveWriter archive = archive_model(response);
        end_helper(archive);
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace campuswalk::scene
