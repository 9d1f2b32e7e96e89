#include "scene/osm/read/raw_map.h"

#include <new>
#include <string_view>

#include <osmium/io/pbf_input.hpp>
#include <osmium/io/xml_input.hpp>

#include "scene/osm/read/raw_elements.h"

namespace campuswalk::scene::osm {
namespace {

/// The file under the name that the user gave it, which says what it is: a link's target may be called
/// anything.
osmium::io::File file_of(const std::filesystem::path& file, const SourceMark& mark) {
    const std::string_view name = mark.file;
    const bool is_pbf = name.ends_with(".pbf");
    const bool is_xml = name.ends_with(".osm") || name.ends_with(".xml");
    return osmium::io::File(file.string(), is_pbf ? "pbf" : is_xml ? "osm" : "");
}

std::optional<GeographicBox> bounds_of(const osmium::io::Header& header) {
    const osmium::Box box = header.joined_boxes();
    return box.valid() ? std::optional(shorter_way({box.bottom_left().lat(), box.bottom_left().lon(),
                                                    box.top_right().lat(), box.top_right().lon()}))
                       : std::nullopt;
}

/// What libosmium throws, as errors about the file.
template <typename Read>
auto reported(const SourceMark& mark, const Read& read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const TooManyNodes&) {
        throw InputError(mark, "bad-size",
                         "it has more than " + std::to_string(kMaxMapNodes / 1'000'000) +
                             " million nodes; choose a part of it with --bbox or --center");
    } catch (const osmium::xml_error& error) {
        SourceMark at = mark;
        at.line = static_cast<int>(error.line);
        at.column = static_cast<int>(error.column);
        throw InputError(at, "bad-map", "it isn't well-formed XML: " + clean(error.error_string));
    } catch (const std::exception& error) {  // libosmium's, protozero's and zlib's have no common base
        throw InputError(mark, "bad-map", "it can't be read as a map: " + clean(error.what()));
    }
}

}  // namespace

std::optional<GeographicBox> stated_bounds(const std::filesystem::path& file, const SourceMark& mark) {
    return reported(mark, [&] {
        osmium::io::Reader reader(file_of(file, mark), osmium::osm_entity_bits::nothing);
        const std::optional<GeographicBox> bounds = bounds_of(reader.header());
        reader.close();
        return bounds;
    });
}

RawMap read_raw_map(const std::filesystem::path& file, const SourceMark& mark,
                    const std::optional<GeographicBox>& box) {
    RawMap raw = reported(mark, [&] {
        const osmium::io::File opened = file_of(file, mark);
        Editions editions(opened);
        const auto read = [&] {
            return box ? read_section(opened, *box, editions) : read_all(opened, editions);
        };
        RawMap all = read();
        if (editions.choose(opened)) {
            all = read();
            all.ambiguous = editions.ambiguous();
        }
        return all;
    });
    sort_locations(raw.locations);
    return raw;
}

}  // namespace campuswalk::scene::osm
