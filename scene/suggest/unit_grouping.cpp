#include "scene/suggest/unit_grouping.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>

#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"
#include "scene/suggest/house.h"

namespace campuswalk::scene {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kSameHouse = 0.6;  // of the smaller plan

bool stands_in(const UprightBox& box, const Bounds& part) {
    constexpr double kEaves = 0.5;  // metres
    Vector3d middle = part.center();
    middle.y() = box.center.y();
    return box.depth_of(middle) >= -kEaves;
}

/// Whether the triangle is over or under the point of the plan.
bool covers(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector2d& p) {
    const auto side = [&](const Vector3d& from, const Vector3d& to) {
        return (to.x() - from.x()) * (p.y() - from.z()) - (to.z() - from.z()) * (p.x() - from.x());
    };
    const double u = side(a, b);
    const double v = side(b, c);
    const double w = side(c, a);
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

}  // namespace

/// Whether something at a building belongs to it rather than, say, being a wall around the campus.
bool is_part_of(const UprightBox& box, const Bounds& part) {
    constexpr double kReach = 6.0;  // metres, of a porch or a canopy
    const Vector3d half(
        0.5 * (box.size.x() * std::abs(box.along.x()) + box.size.z() * std::abs(box.along.z())), 0.0,
        0.5 * (box.size.x() * std::abs(box.along.z()) + box.size.z() * std::abs(box.along.x())));
    const Vector3d low = box.center - half - Vector3d::Constant(kReach);
    const Vector3d high = box.center + half + Vector3d::Constant(kReach);
    return part.min.x() >= low.x() && part.min.z() >= low.z() && part.max.x() <= high.x() &&
           part.max.z() <= high.z();
}

UnitGrouping::UnitGrouping(const Model& model, const ModelReport& report, double most)
    : model_(model),
      report_(report),
      most_(most),
      structures_(find_structures(model, report)),
      touching_(touching(structures_)) {}

std::optional<UprightBox> UnitGrouping::house_of_units(const std::vector<BuildingUnit>& units) const {
    std::vector<const Structure*> all;
    for (const BuildingUnit& unit : units) {
        for (const std::size_t structure : unit.structures) {
            all.push_back(&structures_[structure]);
        }
    }
    return house_of(model_, all, most_);
}

std::vector<BuildingGroup> UnitGrouping::groups_of(const std::vector<BuildingUnit>& units) const {
    const Pairs pairs = touching_units(units);
    std::vector<BuildingGroup> groups = houses_of(units);
    join_houses(units, pairs, groups);
    GroupOf group_of(units.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (const std::size_t unit : groups[g].units) {
            group_of[unit] = g;
        }
    }
    join_parts(units, pairs, groups, group_of);
    join_fragments(units, pairs, groups, group_of);
    join_parts(units, {}, groups, group_of);  // the roofs of those that fragments made
    return groups;
}

/// Units that are houses by themselves, those in one another as one. Walls and rooms are none unless
/// there is a house among them.
std::vector<BuildingGroup> UnitGrouping::houses_of(const std::vector<BuildingUnit>& units) const {
    std::vector<std::size_t> houses;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (units[i].house) {
            houses.push_back(i);
        }
    }
    std::ranges::stable_sort(houses, std::greater(),
                             [&](std::size_t unit) { return units[unit].house->footprint(); });
    std::vector<BuildingGroup> groups;
    for (std::size_t i = 0; i < houses.size(); ++i) {
        const UprightBox& box = *units[houses[i]].house;
        if (is_fence(units, houses, i)) {
            continue;
        }
        const auto around = std::ranges::find_if(
            groups, [&](const BuildingGroup& group) { return shared_plan(group.box, box) >= kSameHouse; });
        if (around == groups.end()) {
            groups.push_back({{houses[i]}, box});
        } else {
            around->units.push_back(houses[i]);
        }
    }
    std::erase_if(groups, [&](const BuildingGroup& group) {
        return std::ranges::all_of(group.units, [&](std::size_t unit) {
            return is_building_part_name(model_.nodes[units[unit].node].name);
        });
    });
    return groups;
}

/// Houses that touch are one if one of them has a name and the other, less than half of its size, none that
/// says anything, or if their names say that they are parts of it: `library_hall` and `library_portico`, but
/// neither `House 1` and `House 2` nor what begins as most names do.
void UnitGrouping::join_houses(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                               std::vector<BuildingGroup>& groups) const {
    std::map<std::string, std::size_t> beginnings;
    std::vector<std::vector<std::string>> words(units.size());
    for (std::size_t u = 0; u < units.size(); ++u) {
        words[u] = words_of(model_.nodes[units[u].node].name);
        if (!words[u].empty()) {
            ++beginnings[words[u][0]];
        }
    }
    const auto says_nothing = [&](std::size_t unit) {
        const std::string& name = model_.nodes[units[unit].node].name;
        return is_generated_name(name) || is_default_name(name) || is_identifier(name);
    };
    const auto are_parts_of_one = [&](std::size_t a, std::size_t b) {
        if (says_nothing(a) != says_nothing(b)) {
            const auto [named, other] = says_nothing(a) ? std::pair(b, a) : std::pair(a, b);
            return units[other].house->footprint() < 0.5 * units[named].house->footprint();
        }
        if (words[a].size() < 2 || words[b].size() < 2 || words[a] == words[b] ||
            words[a][0] != words[b][0]) {
            return false;
        }
        const std::size_t alike = beginnings[words[a][0]];
        return !is_default_name(words[a][0]) && (2 * alike <= units.size() || alike == 2);
    };
    const auto group_with = [&](std::size_t unit) {
        return std::ranges::find_if(groups, [&](const BuildingGroup& group) {
            return std::ranges::find(group.units, unit) != group.units.end();
        });
    };
    for (const auto& [a, b] : pairs) {
        if (!units[a].house || !units[b].house || !are_parts_of_one(a, b)) {
            continue;
        }
        const auto first = group_with(a);
        const auto second = group_with(b);
        if (first != groups.end() && second != groups.end() && first != second) {
            const auto [into, from] = std::minmax(first, second);  // the larger comes first
            into->units.insert(into->units.end(), from->units.begin(), from->units.end());
            groups.erase(from);
        }
    }
}

/// Whether what looks like a house surrounds several that are apart, without a roof over them. `houses`
/// are in descending order of footprint.
bool UnitGrouping::is_fence(const std::vector<BuildingUnit>& units, const std::vector<std::size_t>& houses,
                            std::size_t index) const {
    const UprightBox& box = *units[houses[index]].house;
    std::vector<const UprightBox*> apart;
    for (std::size_t i = index + 1; i < houses.size() && apart.size() < 2; ++i) {
        const UprightBox& other = *units[houses[i]].house;
        const bool is_new = std::ranges::none_of(
            apart, [&](const UprightBox* one) { return shared_plan(*one, other) >= kSameHouse; });
        if (is_new && shared_plan(box, other) >= kSameHouse) {
            apart.push_back(&other);
        }
    }
    return apart.size() >= 2 && !is_roofed(box);
}

/// Whether pieces of wall are a fence: without a roof, and around a building, wide, or long and narrow.
bool UnitGrouping::are_fence(const UprightBox& box, const std::vector<BuildingGroup>& groups) const {
    constexpr double kNarrow = 0.1;     // of the length
    constexpr double kWidest = 2500.0;  // m²
    const auto [width, length] = std::minmax({box.size.x(), box.size.z()});
    const bool may_be = width < kNarrow * length || box.footprint() > kWidest ||
                        std::ranges::any_of(groups, [&](const BuildingGroup& group) {
                            return shared_plan(box, group.box) >= kSameHouse;
                        });
    return may_be && !is_roofed(box);
}

/// Whether there is something over a third of a box's plan, above a visitor's head.
bool UnitGrouping::is_roofed(const UprightBox& box) const {
    constexpr double kHead = 2.0;  // metres
    const double bottom = box.center.y() - 0.5 * box.size.y();
    std::vector<Vector2d> open;
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            const Vector3d p =
                box.center + (i / 6.0) * box.size.x() * box.along + (j / 6.0) * box.size.z() * box.across();
            open.emplace_back(p.x(), p.z());
        }
    }
    const std::size_t all = open.size();
    for (const Structure& structure : structures_) {
        for_each_triangle(model_, model_.nodes[structure.node],
                          [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                              if (std::min({a.y(), b.y(), c.y()}) > bottom + kHead) {
                                  std::erase_if(open, [&](const Vector2d& p) { return covers(a, b, c, p); });
                              }
                          });
    }
    return 3 * open.size() <= 2 * all;
}

UnitGrouping::Pairs UnitGrouping::touching_units(const std::vector<BuildingUnit>& units) const {
    std::vector<std::optional<std::size_t>> unit_of(structures_.size());
    for (std::size_t u = 0; u < units.size(); ++u) {
        for (const std::size_t structure : units[u].structures) {
            unit_of[structure] = u;
        }
    }
    Pairs pairs;
    for (const auto& [a, b] : touching_) {
        if (unit_of[a] && unit_of[b] && *unit_of[a] != *unit_of[b]) {
            pairs.push_back(std::minmax(*unit_of[a], *unit_of[b]));
        }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

/// Parts join the building that they stand in, of several the smallest, or else one that they touch.
void UnitGrouping::join_parts(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                              std::vector<BuildingGroup>& groups, GroupOf& group_of) const {
    const auto join = [&](std::size_t unit, std::size_t group) {
        groups[group].units.push_back(unit);
        group_of[unit] = group;
    };
    for (std::size_t u = 0; u < units.size(); ++u) {
        std::optional<std::size_t> smallest;
        for (std::size_t g = 0; g < groups.size() && !group_of[u]; ++g) {
            if (stands_in(groups[g].box, bounds_of(units[u])) &&
                is_part_of(groups[g].box, bounds_of(units[u])) &&
                (!smallest || groups[g].box.footprint() < groups[*smallest].box.footprint())) {
                smallest = g;
            }
        }
        if (smallest) {
            join(u, *smallest);
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, b] : pairs) {
            if (group_of[a].has_value() == group_of[b].has_value()) {
                continue;
            }
            const std::size_t part = group_of[a] ? b : a;
            const std::size_t group = group_of[a] ? *group_of[a] : *group_of[b];
            if (is_part_of(groups[group].box, bounds_of(units[part]))) {
                join(part, group);
                changed = true;
            }
        }
    }
}

/// Units that touch each other and are houses only together, and walls alone.
void UnitGrouping::join_fragments(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                                  std::vector<BuildingGroup>& groups, GroupOf& group_of) const {
    std::vector<std::size_t> leader(units.size());
    std::iota(leader.begin(), leader.end(), std::size_t{0});
    const auto find = [&](std::size_t unit) {
        while (leader[unit] != unit) {
            unit = leader[unit] = leader[leader[unit]];
        }
        return unit;
    };
    for (const auto& [a, b] : pairs) {
        if (!group_of[a] && !group_of[b]) {
            const std::size_t other = find(b);
            leader[std::max(find(a), other)] = std::min(find(a), other);
        }
    }
    std::vector<std::vector<std::size_t>> members(units.size());
    for (std::size_t u = 0; u < units.size(); ++u) {
        if (!group_of[u]) {
            members[find(u)].push_back(u);
        }
    }
    for (const std::vector<std::size_t>& together : members) {
        std::vector<BuildingUnit> fragments;
        fragments.reserve(together.size());
        for (const std::size_t unit : together) {
            fragments.push_back(units[unit]);
        }
        const auto box = house_of_units(fragments);
        if (box && !are_fence(*box, groups)) {
            for (const std::size_t unit : together) {
                group_of[unit] = groups.size();
            }
            groups.push_back({together, *box});
        }
    }
}

}  // namespace campuswalk::scene
