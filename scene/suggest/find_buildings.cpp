#include "scene/suggest/find_buildings.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"
#include "scene/suggest/unit_grouping.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kMaxShare = 0.6;  // of the model's footprint, if there is any building besides

/// How many levels of open groups the units of a model lie below, on average. Beyond that they count as being
/// at the top: chains of nodes as deep as there are nodes would take forever.
constexpr std::size_t kMostLevels = 32;

class BuildingSearch {
public:
    /// `most` is the largest footprint of a building, m².
    BuildingSearch(const Model& model, const ModelReport& report, double most)
        : model_(model), report_(report), grouping_(model, report, most), structure_of_(model.nodes.size()) {
        for (std::size_t i = 0; i < grouping_.structures().size(); ++i) {
            structure_of_[grouping_.structures()[i].node] = i;
        }
    }

    std::vector<FoundBuilding> run() {
        // Children come after their parents, so each node finds the units of its own.
        std::vector<std::vector<BuildingUnit>> units(model_.nodes.size());
        std::vector<BuildingUnit> top;
        std::size_t visits = 0;
        for (std::size_t n = model_.nodes.size(); n-- > 0;) {
            std::vector<BuildingUnit> own = closed_or_open(n, std::move(units[n]));
            visits += own.size();
            const int parent = model_.nodes[n].parent;
            const bool is_top = parent < 0 || visits > kMostLevels * model_.nodes.size();
            std::vector<BuildingUnit>& above = is_top ? top : units[static_cast<std::size_t>(parent)];
            above.insert(above.end(), std::make_move_iterator(own.begin()),
                         std::make_move_iterator(own.end()));
        }
        std::vector<FoundBuilding> found;
        for (const BuildingGroup& group : grouping_.groups_of(top)) {
            found.push_back(building_of(group, top));
        }
        std::ranges::sort(found, {}, [](const FoundBuilding& each) { return each.nodes.front(); });
        return found;
    }

private:
    FoundBuilding building_of(const BuildingGroup& group, const std::vector<BuildingUnit>& units) const {
        FoundBuilding building;
        UprightBoxFit fit;
        for (const std::size_t unit : group.units) {
            building.nodes.push_back(units[unit].node);
            for (const std::size_t structure : units[unit].structures) {
                for_each_vertex(model_, model_.nodes[grouping_.structures()[structure].node],
                                [&](const Vector3d& p) { fit.add(p); });
            }
        }
        std::ranges::sort(building.nodes);
        building.box = fit.box();
        return building;
    }

    /// A node as one unit, or the units of its children if it is a collection.
    std::vector<BuildingUnit> closed_or_open(std::size_t n, std::vector<BuildingUnit> units) const {
        const bool is_leaf = units.empty();
        if (structure_of_[n]) {
            units.push_back(
                {n, {*structure_of_[n]}, grouping_.house_of_units({{n, {*structure_of_[n]}, {}}})});
        }
        if (is_leaf || units.empty() || is_generated_name(model_.nodes[n].name)) {
            return units;
        }
        BuildingUnit closed{n, {}, grouping_.house_of_units(units)};
        if (!closed.house || !is_part_of(*closed.house, report_.nodes[n].bounds) ||
            !(are_named_after(n, units) ||
              is_one(grouping_.groups_of(units), *closed.house, are_pieces_of(n, units)))) {
            return units;
        }
        for (const BuildingUnit& unit : units) {
            closed.structures.insert(closed.structures.end(), unit.structures.begin(), unit.structures.end());
        }
        return {std::move(closed)};
    }

    /// Whether a group's name is the beginning of most of its parts' names: `library` of `library_portico`.
    bool are_named_after(std::size_t group, const std::vector<BuildingUnit>& units) const {
        constexpr double kMost = 0.6;
        const std::vector<std::string> name = words_of(model_.nodes[group].name);
        const auto named = std::ranges::count_if(units, [&](const BuildingUnit& unit) {
            const std::vector<std::string> words = words_of(model_.nodes[unit.node].name);
            return words.size() > name.size() && std::equal(name.begin(), name.end(), words.begin());
        });
        return !name.empty() && static_cast<double>(named) >= kMost * static_cast<double>(units.size());
    }

    /// Whether split_nodes() has made the units from the node's triangles.
    bool are_pieces_of(std::size_t node, const std::vector<BuildingUnit>& units) const {
        return std::ranges::all_of(units, [&](const BuildingUnit& unit) {
            const Node& piece = model_.nodes[unit.node];
            return piece.name.empty() && piece.parent == static_cast<int>(node);
        });
    }

    /// Whether what was found in a group, or among a node's pieces, is one building that it is named after.
    bool is_one(const std::vector<BuildingGroup>& groups, const UprightBox& whole, bool are_pieces) const {
        constexpr double kMore = 1.5;   // of the footprint
        constexpr double kYard = 20.0;  // m²
        if (groups.empty()) {
            return are_pieces || grouping_.is_roofed(whole);
        }
        return groups.size() == 1 && whole.footprint() <= kMore * groups[0].box.footprint() + kYard;
    }

    const Model& model_;
    const ModelReport& report_;
    UnitGrouping grouping_;
    std::vector<std::optional<std::size_t>> structure_of_;  ///< by node
};

}  // namespace

std::vector<FoundBuilding> find_buildings(const Model& model, const ModelReport& report) {
    if (report.bounds.empty()) {
        return {};
    }
    const Vector3d size = report.bounds.max - report.bounds.min;
    std::vector<FoundBuilding> found = BuildingSearch(model, report, kMaxShare * size.x() * size.z()).run();
    return found.empty() ? BuildingSearch(model, report, std::numeric_limits<double>::infinity()).run()
                         : found;
}

}  // namespace campuswalk::scene
