#include "scene/import/helper/import_process.h"

#include <string>
#include <utility>

#include "scene/base/binary_archive.h"

namespace campuswalk::scene {
namespace {

ImportedModel import_with(const HelperProgram& helper, const ImportRequest& request) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(request.file.mark, "bad-model", "'" + request.file.file + "' can't be read: " + why);
    };
    const HelperResponse response = ask_helper(helper, write_request(request), request.limits);
    if (!response.failure.empty()) {
        refuse(response.failure);
    }
    try {
        return read_response(response.bytes, response.owner);
    } catch (const DamagedFile& damage) {
        refuse(std::string("its import returned invalid data (") + damage.what() +
               "); do not trust this file");
    }
    return {};
}

}  // namespace

Importer import_in_process(HelperProgram helper, ImportLimits limits, SandboxMode sandbox) {
    return [helper = std::move(helper), limits, sandbox](const SceneFile& file, EmptyModel if_empty) {
        return import_with(helper, {file, if_empty, limits_for(file.path, limits), sandbox});
    };
}

}  // namespace campuswalk::scene
