#include "tools/campuswalk/explore/cell_outlines.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <map>

namespace campuswalk::tools::explore {

namespace {

/// East, north, west, south: the sides of a cell from its lower left vertex on, and the cells beyond them.
struct Side {
    UnitCell from;  ///< of the cell's vertices
    UnitCell beyond;
};
constexpr std::array<Side, 4> kSides{
    {{{0, 0}, {0, -1}}, {{1, 0}, {1, 0}}, {{1, 1}, {0, 1}}, {{0, 1}, {-1, 0}}}};
constexpr std::array<UnitCell, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

UnitCell plus(const UnitCell& a, const UnitCell& b) {
    return {a.first + b.first, a.second + b.second};
}

/// Follows the sides of cells that have no neighbour there, with the cells to the left.
class Outlines {
public:
    explicit Outlines(const std::set<UnitCell>& cells) : cells_(cells) {
        for (const UnitCell& cell : cells) {
            for (std::size_t side = 0; side < 4; ++side) {
                if (!cells.contains(plus(cell, kSides[side].beyond))) {
                    sides_[plus(cell, kSides[side].from)].set(side);
                }
            }
        }
    }

    std::vector<CellPolygon> polygons() {
        label_parts();
        std::vector<CellPolygon> polygons(parts_);
        // From the lowest vertex on, each part's outer ring comes before its holes.
        for (auto vertex = sides_.begin(); vertex != sides_.end(); ++vertex) {
            for (std::size_t side = 0; side < 4; ++side) {
                if (vertex->second.test(side)) {
                    const std::size_t part = part_of_.at(left_of(vertex->first, side));
                    polygons[part].push_back(ring_from(vertex->first, side));
                }
            }
        }
        return polygons;
    }

private:
    void label_parts() {
        for (const UnitCell& first : cells_) {
            if (part_of_.contains(first)) {
                continue;
            }
            std::vector<UnitCell> open{first};
            part_of_[first] = parts_;
            while (!open.empty()) {
                const UnitCell cell = open.back();
                open.pop_back();
                for (const Side& side : kSides) {
                    const UnitCell beside = plus(cell, side.beyond);
                    if (cells_.contains(beside) && part_of_.emplace(beside, parts_).second) {
                        open.push_back(beside);
                    }
                }
            }
            ++parts_;
        }
    }

    static UnitCell left_of(const UnitCell& vertex, std::size_t side) {
        return {vertex.first - kSides[side].from.first, vertex.second - kSides[side].from.second};
    }

    /// Takes the sides of the ring away. Where two cells touch at a vertex, it stays with its own.
    Ring ring_from(const UnitCell& start, std::size_t direction) {
        Ring ring;
        UnitCell at = start;
        std::size_t before = 4;
        while (true) {
            std::bitset<4>& here = sides_[at];
            if (before < 4) {
                const std::size_t left = (before + 1) % 4;
                const std::size_t right = (before + 3) % 4;
                direction = here.test(left) ? left : here.test(before) ? before : right;
            }
            if (!here.test(direction)) {
                break;
            }
            here.reset(direction);
            if (direction != before) {
                ring.push_back(at);
            }
            at = plus(at, kDirections[direction]);
            before = direction;
        }
        ring.push_back(ring.front());
        return ring;
    }

    const std::set<UnitCell>& cells_;
    std::map<UnitCell, std::bitset<4>> sides_;  ///< by the vertex that they start from
    std::map<UnitCell, std::size_t> part_of_;
    std::size_t parts_ = 0;
};

}  // namespace

std::vector<CellPolygon> outlines_of(const std::set<UnitCell>& cells) {
    return Outlines(cells).polygons();
}

}  // namespace campuswalk::tools::explore
