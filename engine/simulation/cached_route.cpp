#include "engine/simulation/cached_route.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

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
constexpr scene::FileKind kRouteFile = {{'c', 'w', ' ', 'r', 'o', 'u', 't', 'e'}, 9};

/// What is remembered of a campus has so many pieces of about 100 bytes at most: some 20 MB in all. A route
/// takes about as much as ten more.
constexpr std::size_t kMostPieces = 200'000;
constexpr std::size_t kPiecesOfRoute = 10;

// ---- what it depends on -------------------------------------------------------------------------------

class RouteHasher {
public:
    void add(double number) { hasher_.add_number(number); }
    void add(std::uint64_t number) { hasher_.add_number(number); }
    void add(const Vector3d& p) {
        add(p.x());
        add(p.y());
        add(p.z());
    }
    void add(const Target& target) {
        hasher_.add_text(target.label);
        add(target.point);
        add(std::uint64_t{target.has_height ? 1U : 0U});
    }
    void add(const Avoided& avoided) {
        hasher_.add_text(avoided.objects ? avoided.objects->glob : "");
        add(std::uint64_t{avoided.objects ? 1U : 0U});
        add(avoided.center);
        add(avoided.radius);
    }
    template <typename Item>
    void add(const std::vector<Item>& list) {
        add(std::uint64_t{list.size()});
        for (const Item& item : list) {
            add(item);
        }
    }
    void add(const GoToStep& step) {
        add(step.target);
        add(step.through);
        add(step.avoid);
        add(static_cast<std::uint64_t>(step.prefer));
        add(step.within);
    }
    void add(const collision::MoverState& state) {
        add(state.foot);
        add(state.vertical_speed);
        add(state.slide_velocity);
        add(std::uint64_t{state.grounded ? 1U : 0U});
        add(state.fall_from);
        add(state.support_y);
    }
    /// The step says what `keep_out`, `avoided` and `is_tight` are; `ground` makes no difference.
    void add(const RouteSettings& settings) {
        const StrideSettings& strides = settings.strides;
        const collision::MoverSettings& body = strides.body;
        for (const double number : {body.height, body.radius, body.step_height, body.min_up, body.skin,
                                    body.gravity, strides.full_height.value_or(0.0), strides.seconds,
                                    strides.walk_speed, strides.run_speed, strides.jump_speed}) {
            add(number);
        }
        add(std::uint64_t{settings.max_nodes});
        add(settings.solids);
    }
    void add(const collision::QueryFilter& solids) {
        add(static_cast<std::uint64_t>(solids.detection));
        add(std::uint64_t{solids.ignored_layers});
        for (std::size_t i = 0; solids.disabled != nullptr && i < solids.disabled->size(); ++i) {
            if ((*solids.disabled)[i]) {
                add(std::uint64_t{i});
            }
        }
    }

    ContentHash result() const { return hasher_.result(); }

private:
    ContentHasher hasher_;
};

/// In one campus.
ContentHash key_of_route(const RouteInputs& inputs) {
    RouteHasher hasher;
    hasher.add(inputs.step);
    hasher.add(inputs.from);
    hasher.add(inputs.settings);
    return hasher.result();
}

ContentHash key_of_file(const ContentHash& route, const ContentHash& campus) {
    ContentHasher hasher;
    hasher.add_text(kRouteKind);
    hasher.add_hash(campus);
    hasher.add_hash(route);
    return hasher.result();
}

// ---- the file -----------------------------------------------------------------------------------------

void put_point(ArchiveWriter& out, const Vector3d& p) {
    out.put(p.x());
    out.put(p.y());
    out.put(p.z());
}

void put_flag(ArchiveWriter& out, bool value) {
    out.put(std::uint32_t{value ? 1U : 0U});
}

std::vector<std::byte> archive_route(const PlannedRoute& planned) {
    ArchiveWriter out(kRouteFile);
    out.put_text(planned.why_not);
    put_flag(out, planned.why_at.has_value());
    put_point(out, planned.why_at.value_or(Vector3d::Zero()));
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
    const Vector3d p(x, y, in.take<double>());
    if (!p.allFinite()) {
        throw DamagedFile("a place in it is nowhere");
    }
    return p;
}

PlannedRoute read_route_file(std::span<const std::byte> bytes) {
    constexpr std::size_t kMinPieceBytes = 80;
    ArchiveReader in(bytes, kRouteFile);
    PlannedRoute planned;
    planned.why_not = in.take_text();
    const bool is_anywhere = in.take_flag();
    const Vector3d why_at = take_point(in);
    planned.why_at = is_anywhere ? std::optional(why_at) : std::nullopt;
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
    if (planned.why_not.empty() == planned.route.pieces.empty()) {
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

PlannedRoute stored_or_planned(const ContentHash& route, const RouteCache& cache,
                               const std::function<PlannedRoute()>& plan) {
    const ContentHash key = key_of_file(route, cache.campus);
    if (std::optional<PlannedRoute> stored = stored_route(key, *cache.folder)) {
        return std::move(*stored);
    }
    // Walking everywhere takes long: workers that ask for the same at once wait for the first. If it stores
    // nothing, as it guessed the route or was killed, those that waited go on all at once.
    const std::optional<scene::CacheClaim> claim = cache.folder->claim(key);
    if (std::optional<PlannedRoute> stored = stored_route(key, *cache.folder)) {
        return std::move(*stored);
    }
    PlannedRoute planned = plan();
    if (planned.route.searched || !planned.why_not.empty()) {
        const std::vector<std::byte> bytes = archive_route(planned);
        const std::span<const std::byte> buffer(bytes);
        cache.folder->store(key, kRouteKind, std::span(&buffer, 1));
    }
    return planned;
}

}  // namespace

PlannedRoute cached_route(const RouteInputs& inputs, RouteMemory& memory,
                          const std::function<PlannedRoute()>& plan) {
    const ContentHash key = key_of_route(inputs);
    if (const auto known = memory.planned.find(key.bytes); known != memory.planned.end()) {
        return known->second;
    }
    PlannedRoute planned = memory.cache ? stored_or_planned(key, *memory.cache, plan) : plan();
    planned.route.path = {};  // far larger than the rest
    const std::size_t pieces = planned.route.pieces.size() + kPiecesOfRoute;
    if (memory.pieces + pieces > kMostPieces) {
        memory.planned.clear();
        memory.pieces = 0;
    }
    memory.planned.emplace(key.bytes, planned);
    memory.pieces += pieces;
    return planned;
}

}  // namespace campuswalk::engine
