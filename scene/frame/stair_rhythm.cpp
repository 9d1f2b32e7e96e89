#include "scene/frame/stair_rhythm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "scene/base/quantile.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

struct Tread {
    Vector3d center = Vector3d::Zero();
    double width = 0.0;
    double depth = 0.0;
};

/// A tread is long and narrow, and its surface fills its box.
std::optional<Tread> tread_of(const LevelPatch& patch) {
    constexpr double kMinFilled = 0.7;
    const auto [depth, width] = std::minmax({patch.box.size.x(), patch.box.size.z()});
    const bool fits = depth > 0.0 && width >= 1.5 * depth && width <= 60.0 * depth &&
                      patch.area >= kMinFilled * patch.box.footprint();
    return fits ? std::optional(Tread{patch.box.center, width, depth}) : std::nullopt;
}

double going_between(const Tread& low, const Tread& high) {
    const Vector3d off = high.center - low.center;
    return std::sqrt(off.x() * off.x() + off.z() * off.z());
}

/// Whether one may be the step above the other.
bool follows(const Tread& low, const Tread& high) {
    const double rise = high.center.y() - low.center.y();
    const double going = going_between(low, high);
    const auto alike = [](double a, double b) { return std::max(a, b) <= 1.25 * std::min(a, b); };
    return rise > 0.0 && rise >= 0.35 * going && rise <= 0.85 * going && alike(low.width, high.width) &&
           alike(low.depth, high.depth) && going >= 0.6 * low.depth && going <= 1.3 * low.depth;
}

/// Treads by where they are, in cells as large as treads of their depth need.
class TreadGrid {
public:
    explicit TreadGrid(const std::vector<Tread>& treads) {
        for (std::size_t t = 0; t < treads.size(); ++t) {
            const int level = level_of(treads[t]);
            cells_[key_of(level, treads[t].center)].push_back(t);
        }
    }

    /// Visits no more than `most` treads near this one whose depth is between half and twice as large.
    template <typename Visit>
    void for_each_near(const Tread& tread, std::size_t most, const Visit& visit) const {
        for (int level = level_of(tread) - 1; level <= level_of(tread) + 1; ++level) {
            const auto [own_level, x, y, z] = key_of(level, tread.center);
            for (int i = 0; i < 27; ++i) {
                const auto cell = cells_.find({level, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
                for (std::size_t t = 0; cell != cells_.end() && most > 0 && t < cell->second.size();
                     ++t, --most) {
                    visit(cell->second[t]);
                }
            }
        }
    }

private:
    using Key = std::array<std::int64_t, 4>;

    static int level_of(const Tread& tread) {
        int exponent = 0;
        std::frexp(tread.depth, &exponent);
        return exponent;
    }
    static Key key_of(int level, const Vector3d& p) {
        const double size = std::ldexp(2.0, level);  // two treads, each less deep than 2^level
        const auto number = [&](double value) {
            constexpr double kMost = 1e15;
            return static_cast<std::int64_t>(std::clamp(std::floor(value / size), -kMost, kMost));
        };
        return {level, number(p.x()), number(p.y()), number(p.z())};
    }

    std::map<Key, std::vector<std::size_t>> cells_;
};

/// Finds for each tread the nearest one that follows it.
std::vector<std::optional<std::size_t>> link(const std::vector<Tread>& treads) {
    constexpr std::size_t kMostNear = 256;  // treads that are looked at for each
    const TreadGrid grid(treads);
    std::vector<std::optional<std::size_t>> above(treads.size());
    for (std::size_t low = 0; low < treads.size(); ++low) {
        grid.for_each_near(treads[low], kMostNear, [&](std::size_t high) {
            if (follows(treads[low], treads[high]) &&
                (!above[low] || going_between(treads[low], treads[high]) <
                                    going_between(treads[low], treads[*above[low]]))) {
                above[low] = high;
            }
        });
    }
    return above;
}

/// The flight that begins here, as long as its rises stay alike; its treads are marked as used.
StairRhythm rhythm_from(const std::vector<Tread>& treads, std::size_t first,
                        const std::vector<std::optional<std::size_t>>& above, std::vector<bool>& is_used) {
    std::vector<double> rises;
    std::vector<double> goings;
    std::size_t at = first;
    is_used[at] = true;
    while (above[at] && !is_used[*above[at]]) {
        const Tread& low = treads[at];
        const Tread& high = treads[*above[at]];
        const double rise = high.center.y() - low.center.y();
        if (!rises.empty() && std::abs(rise - rises.front()) > 0.1 * rises.front()) {
            break;
        }
        rises.push_back(rise);
        goings.push_back(going_between(low, high));
        at = *above[at];
        is_used[at] = true;
    }
    return rises.empty() ? StairRhythm() : StairRhythm{rises.size(), median(rises), median(goings)};
}

}  // namespace

std::vector<StairRhythm> stair_rhythms(const std::vector<LevelPatch>& patches) {
    constexpr std::size_t kLeastRisers = 3;
    std::vector<Tread> treads;
    for (const LevelPatch& patch : patches) {
        if (const auto tread = tread_of(patch)) {
            treads.push_back(*tread);
        }
    }
    std::ranges::stable_sort(treads, {}, [](const Tread& tread) { return tread.center.y(); });
    const std::vector<std::optional<std::size_t>> above = link(treads);
    std::vector<bool> is_used(treads.size(), false);
    std::vector<StairRhythm> found;
    for (std::size_t t = 0; t < treads.size(); ++t) {
        if (is_used[t]) {
            continue;
        }
        const StairRhythm rhythm = rhythm_from(treads, t, above, is_used);
        if (rhythm.risers >= kLeastRisers) {
            found.push_back(rhythm);
        }
    }
    return found;
}

}  // namespace campuswalk::scene
