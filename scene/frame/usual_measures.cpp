#include "scene/frame/usual_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "scene/base/quantile.h"
#include "scene/frame/stair_rhythm.h"
#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/suggest/split_nodes.h"
#include "scene/suggest/structures.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr std::array<UsualSize, 8> kUsual = {
    {{MeasureKind::riser, "riser", "risers", "high", 0.1, 0.33, 0.17},
     {MeasureKind::storey, "storey", "storeys", "apart", 2.3, 5.5, 3.3},
     {MeasureKind::door, "door", "doors", "high", 1.8, 3.2, 2.1},
     {MeasureKind::chair, "chair", "chairs", "high", 0.4, 1.3, 0.9},
     {MeasureKind::table, "table", "tables", "high", 0.55, 1.15, 0.75},
     {MeasureKind::car, "car", "cars", "long", 3.0, 6.5, 4.4},
     {MeasureKind::person, "person", "people", "high", 1.2, 2.1, 1.7},
     {MeasureKind::house, "house", "houses", "high", 2.5, 60.0, 9.0}}};

template <std::size_t Count>
bool has_word(std::string_view name, const std::array<std::string_view, Count>& words) {
    return std::ranges::any_of(words_of(name), [&](const std::string& word) {
        return std::ranges::find(words, std::string_view(word)) != words.end();
    });
}

bool is_chair_name(std::string_view name) {
    constexpr std::array<std::string_view, 10> kWords = {"chair", "chairs", "stuhl", "chaise", "silla",
                                                         "sedia", "stoel",  "椅子",  "椅",     "의자"};
    return has_word(name, kWords);
}

bool is_table_name(std::string_view name) {
    constexpr std::array<std::string_view, 12> kWords = {"table", "tables", "desk",  "tisch",
                                                         "mesa",  "tavolo", "tafel", "escritorio",
                                                         "桌子",  "桌",     "机",    "책상"};
    return has_word(name, kWords);
}

bool is_car_name(std::string_view name) {
    constexpr std::array<std::string_view, 9> kWords = {"car",     "cars",    "auto", "coche", "carro",
                                                        "voiture", "vehicle", "汽车", "자동차"};
    constexpr std::array<std::string_view, 5> kPlaces = {"park", "parking", "port", "wash", "lot"};
    return has_word(name, kWords) && !has_word(name, kPlaces);
}

bool is_person_name(std::string_view name) {
    constexpr std::array<std::string_view, 8> kWords = {"person",  "people", "man",      "woman",
                                                        "persona", "mensch", "personne", "人"};
    return has_word(name, kWords);
}

/// The size of each part that is named so, with what is below it.
std::vector<Vector3d> named_sizes(const Model& model, const std::vector<NodeReport>& nodes,
                                  bool (*name_matches)(std::string_view)) {
    const std::vector<std::size_t> part = named_parts(model, name_matches);
    std::vector<Vector3d> sizes;
    for (std::size_t n = 0; n < part.size(); ++n) {
        if (part[n] == n && !nodes[n].bounds.empty()) {
            sizes.emplace_back(nodes[n].bounds.max - nodes[n].bounds.min);
        }
    }
    return sizes;
}

void add_doors(const Model& model, const std::vector<NodeReport>& nodes, std::vector<Measure>& measures) {
    std::vector<double> heights;
    for (const Vector3d& size : door_leaves(model, nodes)) {
        if (size.y() >= 0.9 * size.maxCoeff()) {
            heights.push_back(size.y());
        }
    }
    if (!heights.empty()) {
        // One may be a cathedral's or a cupboard's, but none is ten times as high as others.
        const double usual = median(heights);
        const double off = usual / usual_size(MeasureKind::door).typical;
        const double weight = heights.size() > 1 || off >= 10.0 || off <= 0.1 ? 2.0 : 1.0;
        measures.push_back({MeasureKind::door, heights.size(), usual, weight});
    }
}

/// Measures what is named so by its height, or what is long by its longer side. Parts of one thing, such as a
/// chair's leg, may be named so, too, which is why nearly the largest counts.
void add_named(const Model& model, const std::vector<NodeReport>& nodes, MeasureKind kind,
               bool (*name_matches)(std::string_view), std::vector<Measure>& measures) {
    constexpr double kLargest = 0.9;
    std::vector<double> sizes;
    for (const Vector3d& size : named_sizes(model, nodes, name_matches)) {
        sizes.push_back(kind == MeasureKind::car ? std::max(size.x(), size.z()) : size.y());
    }
    if (const double usual = sizes.empty() ? 0.0 : quantile(sizes, kLargest); usual > 0.0) {
        measures.push_back({kind, sizes.size(), usual, sizes.size() > 1 ? 0.5 : 0.25});
    }
}

void add_risers(const std::vector<LevelPatch>& patches, std::vector<Measure>& measures) {
    constexpr std::size_t kMany = 8;  // risers
    constexpr std::size_t kSome = 5;
    std::vector<double> risers;
    for (const StairRhythm& rhythm : stair_rhythms(patches)) {
        risers.insert(risers.end(), rhythm.risers, rhythm.riser);
    }
    if (!risers.empty()) {
        const double weight = risers.size() >= kMany ? 2.0 : risers.size() >= kSome ? 1.0 : 0.4;
        measures.push_back({MeasureKind::riser, risers.size(), median(risers), weight});
    }
}

/// How much of the smaller plan lies within the other one.
double shared(const UprightBox& a, const UprightBox& b) {
    const auto overlap = [](double center_a, double size_a, double center_b, double size_b) {
        return std::min(center_a + 0.5 * size_a, center_b + 0.5 * size_b) -
               std::max(center_a - 0.5 * size_a, center_b - 0.5 * size_b);
    };
    const double x = overlap(a.center.x(), a.size.x(), b.center.x(), b.size.x());
    const double z = overlap(a.center.z(), a.size.z(), b.center.z(), b.size.z());
    return x > 0.0 && z > 0.0 ? x * z / std::min(a.footprint(), b.footprint()) : 0.0;
}

/// A floor, and the next one above it.
struct FloorPair {
    double area = 0.0;  ///< of the smaller
    double gap = 0.0;
};

std::vector<FloorPair> floor_pairs(std::vector<LevelPatch> patches) {
    constexpr std::size_t kMostFloors = 300;
    constexpr double kLarge = 0.3;  // of the other floor
    std::ranges::stable_sort(patches, std::greater(), &LevelPatch::area);
    patches.resize(std::min(patches.size(), kMostFloors));
    std::ranges::stable_sort(patches, {}, [](const LevelPatch& patch) { return patch.box.center.y(); });
    std::vector<FloorPair> pairs;
    for (std::size_t low = 0; low < patches.size(); ++low) {
        const LevelPatch& floor = patches[low];
        const auto above = std::find_if(
            patches.begin() + static_cast<std::ptrdiff_t>(low) + 1, patches.end(),
            [&](const LevelPatch& high) {
                return std::min(high.area, floor.area) >= kLarge * std::max(high.area, floor.area) &&
                       high.box.center.y() > floor.box.center.y() && shared(floor.box, high.box) >= 0.5;
            });
        if (above == patches.end()) {
            continue;
        }
        const double gap = above->box.center.y() - floor.box.center.y();
        const double side = std::sqrt(floor.area);
        if (gap > 0.08 * side && gap < 1.5 * side) {  // no slab's two sides, and no roof far above
            pairs.push_back({std::min(floor.area, above->area), gap});
        }
    }
    return pairs;
}

/// Floors above one another, not shelves beside them: three gaps that are alike.
void add_storeys(std::vector<LevelPatch> patches, std::vector<Measure>& measures) {
    constexpr double kSmall = 0.1;  // of the largest
    const std::vector<FloorPair> pairs = floor_pairs(std::move(patches));
    double largest = 0.0;
    for (const FloorPair& pair : pairs) {
        largest = std::max(largest, pair.area);
    }
    std::vector<double> gaps;
    for (const FloorPair& pair : pairs) {
        if (pair.area >= kSmall * largest) {
            gaps.push_back(pair.gap);
        }
    }
    if (gaps.size() < 3) {
        return;
    }
    const double usual = median(gaps);
    const auto alike =
        std::ranges::count_if(gaps, [&](double gap) { return std::abs(gap - usual) <= 0.15 * usual; });
    if (alike >= 3 && 2 * alike >= static_cast<std::ptrdiff_t>(gaps.size())) {
        measures.push_back({MeasureKind::storey, static_cast<std::size_t>(alike), usual, 0.4});
    }
}

/// Whether one of them surrounds most of the others, as the walls of a room surround what is in it.
bool are_indoors(const std::vector<Bounds>& apart, const Bounds& all) {
    constexpr double kMost = 0.5;  // of the plan
    const Vector3d whole = all.max - all.min;
    return std::ranges::any_of(apart, [&](const Bounds& bounds) {
        const Vector3d size = bounds.max - bounds.min;
        return size.x() * size.z() > kMost * whole.x() * whole.z();
    });
}

/// Those that stand apart under the open sky, at least three, or one that is larger than any house.
void add_houses(const Model& model, std::vector<Measure>& measures) {
    constexpr double kSmall = 0.2;  // of the widest's footprint
    const SplitModel split = split_nodes(model);
    ModelReport report;
    report.nodes = split.report;
    std::vector<Bounds> apart;
    double widest = 0.0;
    double tallest = 0.0;
    for (const Structure& structure : find_structures(split.model, report)) {
        const WallSum walls = sum_of(structure.walls);
        if (walls.bounds.empty() || !walls.is_built()) {
            continue;
        }
        const Vector3d size = walls.bounds.max - walls.bounds.min;
        const double side = std::sqrt(size.x() * size.z());
        tallest = std::max(tallest, size.y());
        if (side > 0.0 && size.y() >= 0.15 * side && size.y() <= 6.0 * side) {
            apart.push_back(walls.bounds);
            widest = std::max(widest, side * side);
        }
    }
    if (are_indoors(apart, world_bounds(model))) {
        return;
    }
    std::vector<double> heights;
    for (const Bounds& bounds : apart) {
        const Vector3d size = bounds.max - bounds.min;
        if (size.x() * size.z() >= kSmall * widest) {
            heights.push_back(size.y());
        }
    }
    // What is low beside the walls around it is furniture; nothing that people built is as large as the
    // other.
    constexpr double kHuge = 400.0;  // metres wide
    constexpr double kHigh = 60.0;   // metres
    const bool are_houses = heights.size() >= 3 && median(heights) >= 0.3 * tallest;
    const bool are_huge = !heights.empty() && widest >= kHuge * kHuge && median(heights) > kHigh;
    if (are_houses || are_huge) {
        measures.push_back({MeasureKind::house, heights.size(), median(heights), 0.5});
    }
}

}  // namespace

const UsualSize& usual_size(MeasureKind kind) {
    return *std::ranges::find(kUsual, kind, &UsualSize::kind);
}

std::vector<Vector3d> door_leaves(const Model& model, const std::vector<NodeReport>& nodes) {
    constexpr double kMost = 0.6;  // of the model's size
    const Bounds bounds = world_bounds(model);
    std::vector<Vector3d> leaves;
    for (const Vector3d& size : named_sizes(model, nodes, is_door_name)) {
        std::array<double, 3> sides = {size.x(), size.y(), size.z()};
        std::ranges::sort(sides);
        const auto& [thickness, width, height] = sides;
        if (width > 0.0 && thickness <= 0.4 * width && height >= 1.2 * width && height <= 4.0 * width &&
            height <= kMost * (bounds.max - bounds.min).maxCoeff()) {
            leaves.push_back(size);
        }
    }
    return leaves;
}

std::vector<Measure> measure_usual(const Model& model, const std::vector<NodeReport>& nodes,
                                   const std::vector<LevelPatch>& patches) {
    std::vector<Measure> measures;
    add_risers(patches, measures);
    add_storeys(patches, measures);
    add_doors(model, nodes, measures);
    add_named(model, nodes, MeasureKind::chair, is_chair_name, measures);
    add_named(model, nodes, MeasureKind::table, is_table_name, measures);
    add_named(model, nodes, MeasureKind::car, is_car_name, measures);
    add_named(model, nodes, MeasureKind::person, is_person_name, measures);
    add_houses(model, measures);
    return measures;
}

}  // namespace campuswalk::scene
