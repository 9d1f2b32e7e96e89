#include "scene/osm/helper/map_protocol.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campuswalk::scene::osm {
namespace {

constexpr FileKind kMapRequest = {{'c', 'w', ' ', 'm', 'a', 'p', 'r', 'q'}, 1};
constexpr FileKind kMapResponse = {{'c', 'w', ' ', 'm', 'a', 'p', 'r', 's'}, 1};
constexpr std::size_t kMinText = 8;

void put_mark(ArchiveWriter& out, const SourceMark& mark) {
    out.put_text(mark.file);
    out.put(std::int32_t{mark.line});
    out.put(std::int32_t{mark.column});
}

SourceMark take_mark(ArchiveReader& in) {
    SourceMark mark;
    mark.file = in.take_text();
    mark.line = in.take<std::int32_t>();
    mark.column = in.take<std::int32_t>();
    return mark;
}

double take_finite(ArchiveReader& in) {
    const auto value = in.take<double>();
    if (!std::isfinite(value)) {
        throw DamagedFile("a coordinate is not finite");
    }
    return value;
}

void put_point(ArchiveWriter& out, const Eigen::Vector3d& p) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        out.put(p[i]);
    }
}

Eigen::Vector3d take_point(ArchiveReader& in) {
    Eigen::Vector3d p;
    for (Eigen::Index i = 0; i < 3; ++i) {
        p[i] = take_finite(in);
    }
    return p;
}

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
    put_mark(out, request.map.mark);
    out.put_text(request.map.file.string());
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
    out.put(std::uint64_t{files.warnings.size()});
    for (const Diagnostic& diagnostic : files.warnings) {
        out.put(static_cast<std::uint32_t>(diagnostic.severity));
        put_mark(out, diagnostic.mark);
        out.put_text(diagnostic.code);
        out.put_text(diagnostic.message);
    }
    out.put_text(files.campus_yaml);
    out.put_text(files.attribution);
    out.put(std::uint64_t{files.spawns.size()});
    for (const DraftSpawn& spawn : files.spawns) {
        out.put_text(spawn.name);
        put_point(out, spawn.at);
        out.put(spawn.yaw_deg);
    }
    out.put(std::uint64_t{files.places.size()});
    for (const DraftPlace& place : files.places) {
        out.put_text(place.name);
        put_point(out, place.at);
        out.put_text(place.trigger);
        out.put(std::int32_t{place.importance});
    }
    out.put(std::uint64_t{files.buildings});
    out.put(std::uint64_t{files.triangles});
    out.put_text(files.glb);
    return out;
}

MapFiles read_map_response(std::span<const std::byte> bytes) {
    ArchiveReader in(bytes, kMapResponse);
    MapFiles files;
    files.warnings.resize(in.take_count(4 * kMinText));
    for (Diagnostic& diagnostic : files.warnings) {
        diagnostic.severity = static_cast<Severity>(in.take_below(2, "severity"));
        diagnostic.mark = take_mark(in);
        diagnostic.code = in.take_text();
        diagnostic.message = in.take_text();
    }
    files.campus_yaml = in.take_text();
    files.attribution = in.take_text();
    files.spawns.resize(in.take_count(5 * kMinText));
    for (DraftSpawn& spawn : files.spawns) {
        spawn.name = in.take_text();
        spawn.at = take_point(in);
        spawn.yaw_deg = take_finite(in);
    }
    files.places.resize(in.take_count(5 * kMinText));
    for (DraftPlace& place : files.places) {
        place.name = in.take_text();
        place.at = take_point(in);
        place.trigger = in.take_text();
        place.importance = in.take<std::int32_t>();
    }
    files.buildings = static_cast<std::size_t>(in.take<std::uint64_t>());
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
