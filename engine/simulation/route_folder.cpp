#include "engine/simulation/route_folder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/base/binary_archive.h"

namespace campuswalk::engine {

using Eigen::Vector3d;
using scene::ArchiveReader;
using scene::ArchiveWriter;
using scene::ContentHash;
using scene::ContentHasher;
using scene::DamagedFile;

namespace {

const scene::CacheFolder::Kind kRouteKind = "route";
/// Increment the version whenever the layout changes, or how routes are planned and walked.
constexpr scene::FileKind kRouteFile = {{'c', 'w', ' ', 'r', 'o', 'u', 't', 'e'}, 12};

ContentHash key_of_file(const RouteKey& route, const ContentHash& campus) {
    ContentHasher hasher;
    hasher.add_text(kRouteKind);
    hasher.add_hash(campus);
    hasher.add_text(route);
    return hasher.result();
}

void put_point(ArchiveWriter& out, const Vector3d& p) {
    out.put(p.x());
    out.put(p.y());
    out.put(p.z());
}

void put_flag(ArchiveWriter& out, bool value) {
    out.put(std::uint32_t{value ? 1U : 0U});
}

void put_number(ArchiveWriter& out, const std::optional<double>& number) {
    put_flag(out, number.has_value());
    out.put(number.value_or(0.0));
}

void put_place(ArchiveWriter& out, const std::optional<Vector3d>& place) {
    put_flag(out, place.has_value());
    put_point(out, place.value_or(Vector3d::Zero()));
}

void put_reason(ArchiveWriter& out, const Reason& reason) {
    out.put(static_cast<std::uint32_t>(reason.kind));
    out.put_text(reason.object);
    out.put_text(reason.node);
    put_flag(out, reason.is_node);
    out.put_text(reason.name);
    put_place(out, reason.at);
    put_number(out, reason.measured);
    put_number(out, reason.allowed);
    put_number(out, reason.detour);
    put_place(out, reason.from);
    put_place(out, reason.room);
    put_place(out, reason.look_at);
    out.put(reason.more);
    out.put(std::uint64_t{reason.parts.size()});
    for (const Reason& part : reason.parts) {
        put_reason(out, part);
    }
}

std::vector<std::byte> archive_route(const PlannedRoute& planned) {
    ArchiveWriter out(kRouteFile);
    put_flag(out, planned.why_not.has_value());
    if (planned.why_not) {
        put_reason(out, *planned.why_not);
    }
    out.put(std::uint64_t{planned.route.pieces.size()});
    for (const RoutePiece& piece : planned.route.pieces) {
        out.put_text(piece.target.label);
        put_point(out, piece.target.point);
        put_flag(out, piece.target.has_height);
        out.put(piece.within);
        put_flag(out, piece.stride.has_value());
        put_point(out, piece.stride.value_or(Vector3d::Zero()));
        out.put(std::int64_t{piece.ticks});
    }
    return scene::concatenated(out.finish());
}

Vector3d take_point(ArchiveReader& in) {
    const auto x = in.take<double>();
    const auto y = in.take<double>();
    Vector3d p(x, y, in.take<double>());
    if (!p.allFinite()) {
        throw DamagedFile("a place in it is nowhere");
    }
    return p;
}

std::optional<double> take_number(ArchiveReader& in) {
    const bool is_there = in.take_flag();
    const auto number = in.take<double>();
    return is_there ? std::optional(number) : std::nullopt;
}

std::optional<Vector3d> take_place(ArchiveReader& in) {
    const bool is_there = in.take_flag();
    const Vector3d place = take_point(in);
    return is_there ? std::optional(place) : std::nullopt;
}

/// `depth`: of how many reasons it is a part.
Reason take_reason(ArchiveReader& in, int depth) {
    constexpr int kDeepest = 8;
    constexpr std::size_t kMinReasonBytes = 100;
    Reason reason;
    const auto kind = in.take<std::uint32_t>();
    if (kind >= reason_kinds().size() || depth > kDeepest) {
        throw DamagedFile("a reason in it is none");
    }
    reason.kind = static_cast<ReasonKind>(kind);
    reason.object = in.take_text();
    reason.node = in.take_text();
    reason.is_node = in.take_flag();
    reason.name = in.take_text();
    reason.at = take_place(in);
    reason.measured = take_number(in);
    reason.allowed = take_number(in);
    reason.detour = take_number(in);
    reason.from = take_place(in);
    reason.room = take_place(in);
    reason.look_at = take_place(in);
    reason.more = in.take<std::int64_t>();
    const std::size_t parts = in.take_count(kMinReasonBytes);
    for (std::size_t i = 0; i < parts; ++i) {
        reason.parts.push_back(take_reason(in, depth + 1));
    }
    return reason;
}

PlannedRoute read_route_file(std::span<const std::byte> bytes) {
    constexpr std::size_t kMinPieceBytes = 80;
    ArchiveReader in(bytes, kRouteFile);
    PlannedRoute planned;
    if (in.take_flag()) {
        planned.why_not = take_reason(in, 0);
    }
    const std::size_t pieces = in.take_count(kMinPieceBytes);
    for (std::size_t i = 0; i < pieces; ++i) {
        RoutePiece& piece = planned.route.pieces.emplace_back();
        piece.target.label = in.take_text();
        piece.target.point = take_point(in);
        piece.target.has_height = in.take_flag();
        piece.within = in.take<double>();
        const bool strides = in.take_flag();
        const Vector3d stride = take_point(in);
        piece.stride = strides ? std::optional(stride) : std::nullopt;
        piece.ticks = in.take<std::int64_t>();
    }
    in.finish();
    if (planned.why_not.has_value() != planned.route.pieces.empty()) {
        throw DamagedFile("it says neither how one gets there nor why not");
    }
    return planned;
}

std::optional<PlannedRoute> stored_route(const ContentHash& key, const scene::CacheFolder& folder) {
    try {
        const auto file = folder.find(key, kRouteKind);
        return file ? std::optional(read_route_file(file->bytes())) : std::nullopt;
    } catch (const DamagedFile&) {
        return std::nullopt;  // as if it weren't there
    }
}

}  // namespace

PlannedRoute RouteFolder::stored_or_planned(const RouteKey& key,
                                            const std::function<PlannedRoute()>& plan) const {
    const ContentHash file = key_of_file(key, campus_);
    if (std::optional<PlannedRoute> stored = stored_route(file, folder_)) {
        return std::move(*stored);
    }
    // Walking everywhere takes long: workers that ask for the same at once wait for the first. If it stores
    // nothing, as it guessed the route or was killed, those that waited go on all at once.
    const std::optional<scene::CacheClaim> claim = folder_.claim(file);
    if (std::optional<PlannedRoute> stored = stored_route(file, folder_)) {
        return std::move(*stored);
    }
    PlannedRoute planned = plan();
    if (planned.route.searched || planned.why_not) {
        const std::vector<std::byte> bytes = archive_route(planned);
        const std::span<const std::byte> buffer(bytes);
        folder_.store(file, kRouteKind, std::span(&buffer, 1));
    }
    return planned;
}

}  // namespace campuswalk::engine
