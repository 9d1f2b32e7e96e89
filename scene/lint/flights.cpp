#include "scene/lint/flights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "scene/base/quantile.h"
#include "scene/lint/level_patches.h"
#include "scene/model/common_ancestor.h"
#include "scene/model/line_triangle.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kMinGoing = 0.1;     // metres
constexpr double kMaxGoing = 0.9;     // metres
constexpr double kMinRise = 0.05;     // metres
constexpr double kMaxRise = 0.6;      // metres
constexpr double kSameHeight = 0.02;  // metres
constexpr std::size_t kMinTreads = 3;

struct Tread {
    std::size_t node = 0;
    Vector3d center;
    Vector3d along;  ///< unit, the longer side
    double width = 0.0;
    double depth = 0.0;
};

std::optional<Tread> tread_of(const LevelPatch& patch) {
    constexpr double kMinFilled = 0.5;  // winders are triangles
    const UprightBox& box = patch.box;
    const bool is_along = box.size.x() >= box.size.z();
    Tread tread{patch.node, box.center, is_along ? box.along : box.across(),
                std::max(box.size.x(), box.size.z()), std::min(box.size.x(), box.size.z())};
    const bool has_size = tread.width >= 0.4 && tread.width <= 12.0 && tread.depth >= 0.12 &&
                          tread.depth <= 0.75 && box.size.y() <= kSameHeight;
    return has_size && patch.area >= kMinFilled * box.footprint() ? std::optional(tread) : std::nullopt;
}

/// Whether one steps from `low` onto `high`.
bool follows(const Tread& low, const Tread& high) {
    constexpr double kGap = 0.1;  // metres between two treads in plan
    const Vector3d off = high.center - low.center;
    const double going = std::sqrt(off.x() * off.x() + off.z() * off.z());
    const double aside = std::abs(off.dot(low.along));
    return off.y() >= kMinRise && off.y() <= kMaxRise && going >= kMinGoing && going <= kMaxGoing &&
           aside <= 0.5 * low.width && going <= 0.5 * (low.depth + high.depth) + kGap + aside &&
           std::abs(low.along.dot(high.along)) > 0.7;
}

/// By tread: the one above it, or none. Each is above at most one.
std::vector<std::optional<std::size_t>> link(const std::vector<Tread>& treads) {
    const auto cell_of = [](const Vector3d& p) {
        return std::pair(std::floor(p.x()), std::floor(p.z()));  // of a metre
    };
    std::map<std::pair<double, double>, std::vector<std::size_t>> cells;
    for (std::size_t t = 0; t < treads.size(); ++t) {
        cells[cell_of(treads[t].center)].push_back(t);
    }
    std::vector<std::optional<std::size_t>> above(treads.size());
    std::vector<std::optional<std::size_t>> below(treads.size());
    const auto rise = [&](std::size_t low, std::size_t high) {
        return treads[high].center.y() - treads[low].center.y();
    };
    for (std::size_t low = 0; low < treads.size(); ++low) {
        const auto [x, z] = cell_of(treads[low].center);
        for (int k = 0; k < 9; ++k) {
            const int column = k % 3 - 1;
            const int row = k / 3 - 1;
            const auto cell = cells.find({x + column, z + row});
            for (std::size_t i = 0; cell != cells.end() && i < cell->second.size(); ++i) {
                const std::size_t high = cell->second[i];
                if (follows(treads[low], treads[high]) &&
                    (!above[low] || rise(low, high) < rise(low, *above[low]))) {
                    above[low] = high;
                }
            }
        }
    }
    for (std::size_t low = 0; low < treads.size(); ++low) {
        if (above[low] &&
            (!below[*above[low]] || rise(low, *above[low]) < rise(*below[*above[low]], *above[low]))) {
            below[*above[low]] = low;
        }
    }
    for (std::size_t low = 0; low < treads.size(); ++low) {
        if (above[low] && below[*above[low]] != low) {
            above[low].reset();
        }
    }
    return above;
}

/// Chains of treads from the lowest on.
std::vector<std::vector<std::size_t>> chains(const std::vector<std::optional<std::size_t>>& above) {
    std::vector<bool> is_first(above.size(), true);
    for (const std::optional<std::size_t>& next : above) {
        if (next) {
            is_first[*next] = false;
        }
    }
    std::vector<std::vector<std::size_t>> found;
    for (std::size_t t = 0; t < above.size(); ++t) {
        std::vector<std::size_t> chain;
        for (std::optional<std::size_t> next = t; is_first[t] && next; next = above[*next]) {
            chain.push_back(*next);
        }
        if (chain.size() >= kMinTreads) {
            found.push_back(std::move(chain));
        }
    }
    return found;
}

std::size_t holder(const Model& model, const std::vector<Tread>& treads,
                   const std::vector<std::size_t>& chain) {
    std::vector<std::size_t> nodes;
    for (const std::size_t t : chain) {
        nodes.push_back(treads[t].node);
    }
    const std::optional<std::size_t> common = common_ancestor(model, nodes);
    const bool is_root_of_many = common && model.nodes[*common].parent < 0 && *common != nodes.front();
    return common && !is_root_of_many ? *common : nodes.front();
}

/// A vertical line on which the surface nearest to a height is looked for.
struct Probe {
    Vector3d at;
    double low = 0.0;  ///< of the heights that count
    double high = 0.0;
    bool wants_highest = false;
    std::optional<double> found = {};
};

void take(Probe& probe, double y) {
    if (y >= probe.low && y <= probe.high &&
        (!probe.found || (probe.wants_highest ? y > *probe.found : y < *probe.found))) {
        probe.found = y;
    }
}

/// Fills in what the probes find, in one pass over the model.
void look(const Model& model, std::vector<Probe>& probes) {
    std::vector<Probe*> by_x;
    by_x.reserve(probes.size());
    for (Probe& probe : probes) {
        by_x.push_back(&probe);
    }
    const auto x_of = [](const Probe* probe) { return probe->at.x(); };
    std::ranges::stable_sort(by_x, {}, x_of);
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
            const double last = std::max({a.x(), b.x(), c.x()});
            const Vector3d normal = (b - a).cross(c - a);
            if (normal.y() < 0.5 * normal.norm()) {
                return;
            }
            auto at = std::ranges::lower_bound(by_x, std::min({a.x(), b.x(), c.x()}), {}, x_of);
            for (; at != by_x.end() && (*at)->at.x() <= last; ++at) {
                if (const auto up = line_through_triangle({a, b, c}, (*at)->at, Vector3d::UnitY())) {
                    take(**at, (*at)->at.y() + *up);
                }
            }
        });
    }
}

/// In front of the lowest tread, and behind the highest.
std::array<Probe, 2> probes_of(const std::vector<Tread>& treads, const std::vector<std::size_t>& chain) {
    const auto beyond = [&](std::size_t end, std::size_t next) {
        constexpr double kBeyond = 0.1;  // metres
        Vector3d out = treads[end].center - treads[next].center;
        out.y() = 0.0;
        return Vector3d(treads[end].center + (0.5 * treads[end].depth + kBeyond) * out.normalized());
    };
    const Vector3d front = beyond(chain.front(), chain[1]);
    const Vector3d back = beyond(chain.back(), chain[chain.size() - 2]);
    return {Probe{front, front.y() - kMaxRise, front.y() - kSameHeight, true},
            Probe{back, back.y() + kSameHeight, back.y() + kMaxRise, false}};
}

Flight flight_of(const Model& model, const std::vector<Tread>& treads, const std::vector<std::size_t>& chain,
                 const Probe& front, const Probe& back) {
    Flight flight;
    flight.node = holder(model, treads, chain);
    flight.foot = treads[chain.front()].center;
    std::vector<double> goings;
    std::vector<double> widths;
    if (front.found) {
        flight.risers.push_back(front.at.y() - *front.found);
    }
    for (std::size_t i = 0; i < chain.size(); ++i) {
        widths.push_back(treads[chain[i]].width);
        if (i > 0) {
            const Vector3d off = treads[chain[i]].center - treads[chain[i - 1]].center;
            flight.risers.push_back(off.y());
            goings.push_back(std::sqrt(off.x() * off.x() + off.z() * off.z()));
        }
    }
    if (back.found) {
        flight.risers.push_back(*back.found - back.at.y());
    }
    flight.tread_depth = median(std::move(goings));
    flight.width = median(std::move(widths));
    return flight;
}

}  // namespace

std::vector<Flight> find_flights(const Model& model) {
    constexpr double kWeld = 0.001;  // metres
    std::vector<Tread> treads;
    for (const LevelPatch& patch : level_patches(model, kWeld)) {
        if (const auto tread = tread_of(patch)) {
            treads.push_back(*tread);
        }
    }
    const std::vector<std::vector<std::size_t>> found = chains(link(treads));
    std::vector<Probe> probes;
    for (const std::vector<std::size_t>& chain : found) {
        const auto ends = probes_of(treads, chain);
        probes.insert(probes.end(), ends.begin(), ends.end());
    }
    look(model, probes);
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < found.size(); ++i) {
        flights.push_back(flight_of(model, treads, found[i], probes[2 * i], probes[2 * i + 1]));
    }
    std::ranges::stable_sort(flights, {}, &Flight::node);
    return flights;
}

double usual_riser(const Flight& flight) {
    return median(flight.risers);
}

}  // namespace campuswalk::scene
