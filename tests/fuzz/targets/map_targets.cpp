// Maps and heights, as the map helper reads them, and its response.

#include <array>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "scene/base/diagnostic.h"
#include "scene/osm/helper/map_protocol.h"
#include "scene/osm/import_map.h"
#include "tests/fuzz/targets/targets.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::fuzz {

namespace {

constexpr const char* kSquare =
    "<osm version=\"0.6\"><bounds minlat=\"0\" minlon=\"0\" maxlat=\"0.0002\" maxlon=\"0.0002\"/>"
    "<node id=\"1\" lat=\"0\" lon=\"0\"/><node id=\"2\" lat=\"0.0002\" lon=\"0.0002\"/>"
    "<way id=\"3\"><nd ref=\"1\"/><nd ref=\"2\"/><tag k=\"highway\" v=\"footway\"/></way></osm>";

std::string_view text_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void import(const std::string& map, const std::string& heights, const std::string& name,
            std::string_view bytes) {
    static const support::TemporaryFolder folder;
    folder.write(name, bytes);
    if (name != map) {
        folder.write(map, kSquare);
    }
    scene::osm::MapRequest request;
    request.file = folder.path() / map;
    request.mark.file = map;
    if (!heights.empty()) {
        request.heights = folder.path() / heights;
    }
    try {
        scene::osm::import_map(request);
    } catch (const scene::InputError&) {
    }
}

void read_osm(Bytes bytes) {
    import("a.osm", "", "a.osm", text_of(bytes));
}

/// libosmium 2.19 leaves a PBF open that it can't read to its end. The map helper ends after it; here, there
/// would be no descriptors left after some thousand runs.
void read_pbf(Bytes bytes) {
    const int next = ::dup(STDIN_FILENO);
    ::close(next);
    import("b.pbf", "", "b.pbf", text_of(bytes));
    if (::fcntl(next, F_GETFD) != -1) {
        ::close(next);
    }
}

void read_heights(Bytes bytes) {
    import("c.osm", "c.asc", "c.asc", text_of(bytes));
}

/// A tile of SRTM whose heights are these bytes, over and over.
void read_tile(Bytes bytes) {
    constexpr std::size_t kSize = std::size_t{2} * 1201 * 1201;
    if (bytes.empty()) {
        return;
    }
    std::string tile;
    tile.reserve(kSize + bytes.size());
    while (tile.size() < kSize) {
        tile += text_of(bytes);
    }
    tile.resize(kSize);
    import("d.osm", "N00E000.hgt", "N00E000.hgt", tile);
}

/// With a correct header, as a helper that a map has taken over would write it.
void read_map_answer(Bytes bytes) {
    try {
        scene::osm::read_map_response(forged(scene::osm::kMapResponse, bytes));
    } catch (const scene::DamagedFile&) {
    } catch (const scene::InputError&) {
    }
}

constexpr std::array kMapTargets = {Target{"osm", read_osm}, Target{"pbf", read_pbf},
                                    Target{"heights", read_heights}, Target{"tile", read_tile},
                                    Target{"map-answer", read_map_answer}};

}  // namespace

std::span<const Target> map_targets() {
    return kMapTargets;
}

}  // namespace campuswalk::fuzz
