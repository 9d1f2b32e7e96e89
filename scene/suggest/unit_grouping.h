#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"
#include "scene/model/upright_box.h"
#include "scene/suggest/structures.h"

namespace campuswalk::scene {

/// What isn't divided any further: a node and what it has of structures, by their indices.
struct BuildingUnit {
    std::size_t node = 0;
    std::vector<std::size_t> structures;
    std::optional<UprightBox> house;  ///< it is one by itself
};

/// Units that are one building, by their indices.
struct BuildingGroup {
    std::vector<std::size_t> units;
    UprightBox box;
};

/// Decides which units are one building.
class UnitGrouping {
public:
    /// `most` is the largest footprint of a building, m². The model and its report must outlive it.
    UnitGrouping(const Model& model, const ModelReport& report, double most);

    const std::vector<Structure>& structures() const { return structures_; }

    /// The box around units that together are a house.
    std::optional<UprightBox> house_of_units(const std::vector<BuildingUnit>& units) const;

    std::vector<BuildingGroup> groups_of(const std::vector<BuildingUnit>& units) const;

    /// Whether there is something over a third of a box's plan, above a visitor's head.
    bool is_roofed(const UprightBox& box) const;

private:
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    using GroupOf = std::vector<std::optional<std::size_t>>;  ///< by unit

    std::vector<BuildingGroup> houses_of(const std::vector<BuildingUnit>& units) const;
    void join_houses(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                     std::vector<BuildingGroup>& groups) const;
    bool is_fence(const std::vector<BuildingUnit>& units, const std::vector<std::size_t>& houses,
                  std::size_t index) const;
    bool are_fence(const UprightBox& box, const std::vector<BuildingGroup>& groups) const;
    Pairs touching_units(const std::vector<BuildingUnit>& units) const;
    const Bounds& bounds_of(const BuildingUnit& unit) const { return report_.nodes[unit.node].bounds; }
    void join_parts(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                    std::vector<BuildingGroup>& groups, GroupOf& group_of) const;
    void join_fragments(const std::vector<BuildingUnit>& units, const Pairs& pairs,
                        std::vector<BuildingGroup>& groups, GroupOf& group_of) const;

    const Model& model_;
    const ModelReport& report_;
    const double most_;
    std::vector<Structure> structures_;
    Pairs touching_;
};

/// Whether something at a building belongs to it rather than, say, being a wall around the campus.
bool is_part_of(const UprightBox& box, const Bounds& part);

}  // namespace campuswalk::scene
