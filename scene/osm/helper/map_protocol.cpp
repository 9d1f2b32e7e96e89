#include "scene/osm/helper/map_protocol.h"

#include <algorithm>
#include <utility>

#include "scene/osm/helper/draft_archive.h"

namespace campuswalk::scene::osm {
namespace {

constexpr FileKind kMapRequest = {{'c', 'w', ' ', 'm', 'a', 'p', 'r', 'q'}, 2};

void put_section(ArchiveWriter& out, const MapSection& section) {
    out.put(std::uint32_t{section.box.has_value()});
    const GeographicBox box = section.box.value_or(GeographicBox());
    for (const double edge : {box.south, box.west, box.north, box.east}) {
        out.put(edge);
    }
    out.put(std::uint32_t{section.center.has_value()});
    const auto [latitude, longitude] = section.center.value_or(std::pair(0.0, 0.0));
    out.put(latitude);
    out.put(longitude);
    out.put(section.radius);
}

MapSection take_section(ArchiveReader& in) {
    MapSection section;
    const bool has_box = in.take_flag();
    GeographicBox box;
    for (double* edge : {&box.south, &box.west, &box.north, &box.east}) {
        *edge = take_finite(in);
    }
    const bool has_center = in.take_flag();
    const double latitude = take_finite(in);
    const double longitude = take_finite(in);
    section.radius = take_finite(in);
    if (has_box) {
        section.box = box;
    }
    if (has_center) {
        section.center = {latitude, longitude};
    }
    return section;
}

}  // namespace

std::vector<std::byte> write_request(const MapHelperRequest& request) {
    ArchiveWriter out(kMapRequest);
    put(out, request.map.mark);
    out.put_text(request.map.file.string());
    put(out, request.map.heights_mark);
    out.put_text(request.map.heights.string());
    put_section(out, request.map.section);
    out.put(request.limits.memory);
    out.put(request.limits.cpu);
    out.put(request.limits.response);
    out.put(static_cast<std::uint32_t>(request.sandbox));
    return concatenated(out.finish());
}

MapHelperRequest read_map_request(std::span<const std::byte> bytes) {
    ArchiveReader in(bytes, kMapRequest);
    MapHelperRequest request;
    request.map.mark = take_mark(in);
    request.map.file = in.take_text();
    request.map.heights_mark = take_mark(in);
    request.map.heights = in.take_text();
    request.map.section = take_section(in);
    request.limits.memory = in.take<std::uint64_t>();
    request.limits.cpu = in.take<std::uint32_t>();
    request.limits.response = in.take<std::uint64_t>();
    request.sandbox = static_cast<SandboxMode>(in.take_below(3, "sandbox"));
    in.finish();
    return request;
}

ArchiveWriter archive_files(const MapFiles& files) {
    ArchiveWriter out(kMapResponse);
    put_diagnostics(out, files.warnings);
    put_draft(out, files.draft);
    out.put(std::uint64_t{files.triangles});
    out.put_text(files.glb);
    return out;
}

MapFiles read_map_response(std::span<const std::byte> bytes) {
    ArchiveReader in(bytes, kMapResponse);
    MapFiles files;
    files.warnings = take_diagnostics(in);
    files.draft = take_draft(in);
    files.triangles = static_cast<std::size_t>(in.take<std::uint64_t>());
    files.glb = in.take_text();
    in.finish();
    if (std::ranges::any_of(files.warnings,
                            [](const Diagnostic& d) { return d.severity == Severity::error; })) {
        throw InputError(std::move(files.warnings));
    }
    return files;
}

}  // namespace campuswalk::scene::osm
