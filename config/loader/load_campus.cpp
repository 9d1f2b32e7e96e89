#include "config/loader/load_campus.h"

#include "config/loader/campus/geojson_points.h"
#include "config/loader/campus/read_campus.h"
#include "config/loader/read_whole.h"

namespace campuswalk::config {

scene::CampusDescription load_campus_description(const std::filesystem::path& campus_file,
                                                 const SearchPaths& search) {
    return *read_whole_file(campus_file, search, [&](const auto& roots, const auto& mark, auto& diagnostics) {
        return open_campus(campus_file, roots, mark, diagnostics);
    });
}

PlacesRead read_place_file(const PlaceFile& file, const std::optional<scene::GeographicPlace>& origin,
                           const SearchPaths& search) {
    return read_whole_file(file.path, search, [&](const auto& roots, const auto& mark, auto& diagnostics) {
        const YamlNode here;
        const CheckedNode named_at(here, "the file", mark.file, diagnostics);
        PointFile wanted;
        wanted.path = file.path;
        wanted.name_property = file.name_property;
        PlacesRead read;
        for (const NamedPoint& point : read_points(wanted, named_at, roots, origin, read.warnings)) {
            read.positions.push_back(point.position);
        }
        return read;
    });
}

}  // namespace campuswalk::config
