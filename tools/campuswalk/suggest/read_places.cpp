#include "tools/campuswalk/suggest/read_places.h"

#include <filesystem>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

std::vector<Eigen::Vector3d> read_places(const config::PlaceFile& file,
                                         const std::optional<scene::GeographicPlace>& on_earth) {
    config::SearchPaths search = search_paths();
    search.roots.push_back(std::filesystem::absolute(file.path).parent_path());
    try {
        config::PlacesRead read = config::read_place_file(file, on_earth, search);
        diagnose(read.warnings);
        return std::move(read.positions);
    } catch (const scene::InputError& error) {
        if (error.diagnostics().front().code != "no-origin") {
            throw;
        }
        throw error_about(file.path, "no-origin",
                          "it has longitudes and latitudes, but the model doesn't say where it is; pass "
                          "--origin LAT,LON");
    }
}

}  // namespace campuswalk::tools
