#include "engine/simulation/cached_route.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/base/binary_archive.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

constexpr scene::FileKind kKey = {{'c', 'w', ' ', 'r', 't', 'k', 'e', 'y'}, 1};

/// What is remembered of a campus has so many pieces of about 100 bytes at most: some 20 MB in all. A route
/// takes about as much as ten more.
constexpr std::size_t kMostPieces = 200'000;
constexpr std::size_t kPiecesOfRoute = 10;
constexpr std::size_t kBytesOfPiece = 100;

/// Nothing that it writes can be read in two ways: lists and texts come after their lengths, but the last
/// list.
class KeyWriter {
public:
    void add(double number) { out_.put(number); }
    void add(std::uint64_t number) { out_.put(number); }
    void add(const Vector3d& p) {
        add(p.x());
        add(p.y());
        add(p.z());
    }
    void add(const Target& target) {
        out_.put_text(target.label);
        add(target.point);
        add(std::uint64_t{target.has_height ? 1U : 0U});
    }
    void add(const Avoided& avoided) {
        out_.put_text(avoided.objects ? avoided.objects->glob : "");
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

    RouteKey finish() {
        const std::vector<std::byte> bytes = scene::concatenated(out_.finish());
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

private:
    scene::ArchiveWriter out_{kKey};
};

RouteKey key_of_route(const RouteInputs& inputs) {
    KeyWriter key;
    key.add(inputs.step);
    key.add(inputs.from);
    key.add(inputs.settings);
    return key.finish();
}

}  // namespace

PlannedRoute cached_route(const RouteInputs& inputs, RouteMemory& memory,
                          const std::function<PlannedRoute()>& plan) {
    const RouteKey key = key_of_route(inputs);
    if (const auto known = memory.planned.find(key); known != memory.planned.end()) {
        return known->second;
    }
    PlannedRoute planned = memory.store ? memory.store->stored_or_planned(key, plan) : plan();
    planned.route.path = {};  // far larger than the rest
    const std::size_t pieces = planned.route.pieces.size() + key.size() / kBytesOfPiece + kPiecesOfRoute;
    if (memory.pieces + pieces > kMostPieces) {
        memory.planned.clear();
        memory.pieces = 0;
    }
    memory.planned.emplace(key, planned);
    memory.pieces += pieces;
    return planned;
}

}  // namespace campuswalk::engine
