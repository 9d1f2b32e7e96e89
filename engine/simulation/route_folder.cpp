#include "engine/simulation/route_folder.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/events/reason_fields.h"
#include "scene/base/binary_archive.h"
#include "scene/base/field_archive.h"

namespace campuswalk::engine {

using scene::ArchiveReader;
using scene::ArchiveWriter;
using scene::ContentHash;
using scene::ContentHasher;
using scene::DamagedFile;

static void each_field(auto& fields, MaybeConst<Target> auto& target) {
    fields(target.label, target.point, target.has_height);
}
static void each_field(auto& fields, MaybeConst<RoutePiece> auto& piece) {
    fields(piece.target, piece.within, piece.stride, piece.ticks);
}
static void each_field(auto& fields, MaybeConst<PlannedRoute> auto& planned) {
    fields(planned.why_not, planned.route.pieces);
}

namespace {

const scene::CacheFolder::Kind kRouteKind = "route";
/// Increment the version whenever the layout changes, or how routes are planned and walked.
constexpr scene::FileKind kRouteFile = {{'c', 'w', ' ', 'r', 'o', 'u', 't', 'e'}, 13};

ContentHash key_of_file(const RouteKey& route, const ContentHash& campus) {
    ContentHasher hasher;
    hasher.add_text(kRouteKind);
    hasher.add_hash(campus);
    hasher.add_text(route);
    return hasher.result();
}

std::vector<std::byte> archive_route(const PlannedRoute& planned) {
    ArchiveWriter out(kRouteFile);
    scene::FieldWriter fields(out);
    fields(planned);
    return scene::concatenated(out.finish());
}

class RouteReader : public scene::FieldReader<RouteReader> {
public:
    using FieldReader::FieldReader;
    using FieldReader::take;
};

PlannedRoute read_route_file(std::span<const std::byte> bytes) {
    ArchiveReader in(bytes, kRouteFile);
    RouteReader fields(in);
    PlannedRoute planned;
    fields(planned);
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
