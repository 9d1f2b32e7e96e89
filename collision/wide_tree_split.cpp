#include "collision/wide_tree_split.h"

#include <algorithm>
#include <array>

namespace campuswalk::collision {

namespace {

constexpr std::size_t kBins = 16;

/// Triangles that a leaf is expected to take: its corners are used up before its sixteen triangles are.
constexpr std::uint32_t kTypicalLeaf = 14;

/// A split must leave at least one part in sixteen on each side, so that the depth stays logarithmic.
constexpr std::size_t kLopsided = 16;

struct Bin {
    LaneBounds bounds;
    std::uint32_t count = 0;

    void add(const Bin& o) {
        bounds.extend(o.bounds);
        count += o.count;
    }
    float cost() const {
        return bounds.half_area() * static_cast<float>((count + kTypicalLeaf - 1) / kTypicalLeaf);
    }
};

using Row = std::array<Bin, kBins>;

/// Twice the centre: only compared.
Lanes center(const SplitItem& item) {
    return item.bounds.min + item.bounds.max;
}

/// Where centres lie along the three axes, in bins.
struct Binning {
    Lanes low = Lanes::Zero();
    Lanes scale = Lanes::Zero();

    explicit Binning(std::span<const SplitItem> items) {
        LaneBounds centers;
        for (const SplitItem& item : items) {
            centers.extend(center(item));
        }
        const Lanes extent = centers.max - centers.min;
        low = centers.min;
        // Just below the number of bins, so that the greatest centre still falls in the last. What lies
        // closer than this is at one place: the quotient must be finite.
        constexpr float kSamePlace = 1e-35F;
        scale = (extent > kSamePlace).select(Lanes::Constant(kBins * 0.9999F) / extent, Lanes::Zero());
    }

    Eigen::Array4i bins(const SplitItem& item) const { return ((center(item) - low) * scale).cast<int>(); }
};

/// Everything up to `bin` goes to the left.
struct Cut {
    float cost = std::numeric_limits<float>::max();
    int axis = -1;
    int bin = 0;
};

void offer_cuts(const Row& row, int axis, Cut& best) {
    std::array<Bin, kBins> right;  // right[k]: bins k and up
    right[kBins - 1] = row[kBins - 1];
    for (std::size_t k = kBins - 1; k-- > 0;) {
        right[k] = right[k + 1];
        right[k].add(row[k]);
    }
    Bin left;
    for (std::size_t k = 0; k + 1 < kBins; ++k) {
        left.add(row[k]);
        if (left.count == 0 || right[k + 1].count == 0) {
            continue;
        }
        const float cost = left.cost() + right[k + 1].cost();
        if (cost < best.cost) {
            best = {cost, axis, static_cast<int>(k)};
        }
    }
}

Cut best_cut(std::span<const SplitItem> items, const Binning& binning) {
    std::array<Row, 3> rows;
    for (const SplitItem& item : items) {
        const Eigen::Array4i bins = binning.bins(item);
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = rows[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bins[axis])];
            bin.bounds.extend(item.bounds);
            ++bin.count;
        }
    }
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (binning.scale[axis] > 0.0F) {
            offer_cuts(rows[static_cast<std::size_t>(axis)], axis, best);
        }
    }
    return best;
}

/// Half of the items on each side of the axis that their centres differ most along.
std::size_t halve(std::span<SplitItem> items) {
    LaneBounds centers;
    for (const SplitItem& item : items) {
        centers.extend(center(item));
    }
    int longest = 0;
    (centers.max - centers.min).head<3>().maxCoeff(&longest);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [&](const SplitItem& s, const SplitItem& t) {
                         const float x = center(s)[longest];
                         const float y = center(t)[longest];
                         return x != y ? x < y : s.triangle < t.triangle;
                     });
    return half;
}

}  // namespace

std::size_t split_by_area(std::span<SplitItem> items) {
    const Binning binning(items);
    const Cut cut = best_cut(items, binning);
    if (cut.axis < 0) {
        return halve(items);
    }
    const auto middle = std::partition(items.begin(), items.end(), [&](const SplitItem& item) {
        return binning.bins(item)[cut.axis] <= cut.bin;
    });
    const auto left = static_cast<std::size_t>(middle - items.begin());
    const std::size_t least = items.size() / kLopsided;
    return left >= least && items.size() - left >= least ? left : halve(items);
}

}  // namespace campuswalk::collision
