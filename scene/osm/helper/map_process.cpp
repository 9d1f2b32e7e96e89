#include "scene/osm/helper/map_process.h"

#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/import/helper/helper_streams.h"
#include "scene/osm/helper/map_protocol.h"

namespace campuswalk::scene::osm {
namespace {

MapFiles response_to(const MapRequest& request) {
    try {
        return files_of(import_map(request));
    } catch (const InputError& error) {
        MapFiles refusal;
        refusal.warnings = error.diagnostics();
        return refusal;
    } catch (const std::bad_alloc&) {
        MapFiles refusal;
        refusal.warnings = {{Severity::error, request.mark, "bad-map",
                             "it needs more memory than is available; choose a part with --bbox"}};
        return refusal;
    }
}

/// Without links, which a sandbox doesn't follow.
std::filesystem::path without_links(const std::filesystem::path& file) {
    std::error_code ignored;
    std::filesystem::path path = std::filesystem::canonical(file, ignored);
    return path.empty() ? file : path;
}

}  // namespace

MapFiles import_map_in_process(const HelperProgram& helper, const MapRequest& request,
                               const ImportLimits& limits, SandboxMode sandbox) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(request.mark, "bad-map", "it can't be imported: " + why);
    };
    MapHelperRequest asked{request, limits_for(request.file, limits), sandbox};
    asked.map.file = without_links(request.file);
    if (!request.heights.empty()) {
        asked.map.heights = without_links(request.heights);
    }
    const HelperResponse response =
        ask_helper(helper, write_request(asked), asked.limits,
                   {"choose a part of it with --bbox or --center", "download it again, or report it"});
    if (!response.failure.empty()) {
        refuse(response.failure);
    }
    try {
        return read_map_response(response.bytes);
    } catch (const DamagedFile& damage) {
        refuse(std::string("its import returned invalid data (") + damage.what() + ")");
    }
    return {};
}

int serve_map() {
    const std::vector<std::byte> bytes = read_helper_request();
    if (bytes.empty()) {
        return 2;
    }
    try {
        const MapHelperRequest request = read_map_request(bytes);
        limit_process(request.limits);
        enter_sandbox({request.map.file, request.map.heights}, request.sandbox);
        const MapFiles files = response_to(request.map);
        ArchiveWriter archive = archive_files(files);
        end_helper(archive);
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace campuswalk::scene::osm
