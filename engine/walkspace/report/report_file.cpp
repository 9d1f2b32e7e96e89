#include "engine/walkspace/report/report_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "engine/walkspace/report/report_fields.h"
#include "scene/base/field_archive.h"

namespace campuswalk::engine {

using collision::ObjectId;
using scene::ArchiveReader;
using scene::ArchiveWriter;
using scene::DamagedFile;
using scene::FieldWriter;

namespace {

/// Cells are no smaller than this, metres, and no farther away, as they are numbered by `int`.
constexpr double kSmallestCell = 0.01;
constexpr int kFarthestCell = 2'000'000'000;

class ReportReader : public scene::FieldReader<ReportReader> {
public:
    ReportReader(ArchiveReader& in, std::size_t objects) : FieldReader(in), objects_(objects) {}

    /// From now on, nodes must be of this space.
    void require_nodes_of(const WalkSpace& space) { space_ = &space; }

    using FieldReader::take;
    void take(ObjectId& id) { id = static_cast<ObjectId>(archive().take_below(objects_, "an object")); }
    void take(WalkNodeId& id) {
        (*this)(id.tile, id.node);
        if (space_ != nullptr &&
            (id.tile >= space_->tiles.size() || id.node >= space_->tiles[id.tile].nodes.size())) {
            throw DamagedFile("a node in it is out of range");
        }
    }

private:
    std::size_t objects_;
    const WalkSpace* space_ = nullptr;
};

void require(bool holds, const char* fault) {
    if (!holds) {
        throw DamagedFile(fault);
    }
}

// ---- the walk space -----------------------------------------------------------------------------------

void put_tile(ArchiveWriter& out, FieldWriter& fields, const WalkTile& tile) {
    fields(tile.first_cell, std::uint64_t{tile.nodes.size()});
    out.put_all(std::span(tile.nodes));
    fields(tile.keyframes, tile.far_parents, tile.drops);
}

/// Adds the nodes as they were added before, which links them by cell.
void take_nodes(ArchiveReader& in, WalkTile& tile) {
    const std::size_t count = in.take_count(sizeof(WalkNode));
    require(count <= WalkTile::kMaxNodes, "a tile in it has too many nodes");
    for (const WalkNode& node : in.take_all<WalkNode>(count)) {
        require(node.gait < end_of(Gait()) && node.steering <= Stride::kLetGo &&
                    node.parent_tile <= WalkNode::kStart,
                "a node in it is of no known kind");
        tile.add(node);
    }
}

void take_tile(ArchiveReader& in, ReportReader& fields, WalkSpace& space) {
    GridCell first_cell;
    fields(first_cell);
    const std::size_t number = space.tiles.size();
    const auto is_near = [](int at) { return at >= -kFarthestCell && at <= kFarthestCell; };
    require(is_near(first_cell.x) && is_near(first_cell.z), "a place in it is nowhere");
    require(first_of_square(first_cell, WalkTile::kCells) == first_cell &&
                space.add_tile_at(first_cell) == number,
            "its tiles overlap");
    WalkTile& tile = space.tiles[number];
    take_nodes(in, tile);
    fields(tile.keyframes, tile.far_parents, tile.drops);
    const auto by_node = [](const auto& a, const auto& b) { return a.node < b.node; };
    require(
        std::ranges::is_sorted(tile.keyframes, by_node) && std::ranges::is_sorted(tile.far_parents, by_node),
        "its nodes are out of order");
    const auto is_node = [&](const auto& entry) { return entry.node < tile.nodes.size(); };
    require(std::ranges::all_of(tile.drops, is_node), "a node in it is out of range");
}

/// The node's parent, if the file says which it is.
std::optional<WalkNodeId> checked_parent(const WalkSpace& space, const WalkNodeId& id) {
    const WalkTile& tile = space.tiles[id.tile];
    const WalkNode& node = space.node(id);
    if (node.parent_tile == WalkNode::kStart) {
        require(tile.keyframe(id.node) != nullptr, "a start in it has no state");
        return std::nullopt;
    }
    if (node.parent_tile == WalkNode::kFarParent) {
        require(std::ranges::binary_search(tile.far_parents, id.node, {}, &WalkTile::FarParent::node),
                "a node in it has no parent");
    } else {
        require(tile.neighbours[node.parent_tile] != WalkTile::kNoTile, "a node in it has no parent");
    }
    const WalkNodeId parent = *space.parent(id);
    require(parent.tile < space.tiles.size() && parent.node < space.tiles[parent.tile].nodes.size(),
            "a node in it has no parent");
    return parent;
}

/// Every node's parents must lead to a start.
void check_chains(const WalkSpace& space) {
    std::vector<std::vector<bool>> leads_to_start(space.tiles.size());
    for (std::size_t i = 0; i < space.tiles.size(); ++i) {
        leads_to_start[i].resize(space.tiles[i].nodes.size());
    }
    const std::size_t longest = space.node_count();
    std::vector<WalkNodeId> chain;
    for (std::uint32_t tile = 0; tile < space.tiles.size(); ++tile) {
        for (std::uint32_t node = 0; node < space.tiles[tile].nodes.size(); ++node) {
            chain.clear();
            std::optional<WalkNodeId> at = WalkNodeId{tile, static_cast<std::uint16_t>(node)};
            while (at && !leads_to_start[at->tile][at->node]) {
                require(chain.size() < longest, "its chains lead nowhere");
                chain.push_back(*at);
                at = checked_parent(space, *at);
            }
            for (const WalkNodeId& id : chain) {
                leads_to_start[id.tile][id.node] = true;
            }
        }
    }
}

void put_space(ArchiveWriter& out, FieldWriter& fields, const WalkSpace& space) {
    fields(space.grid.cell, space.touched, space.bounds, space.ticks, space.strides,
           std::uint64_t{space.tiles.size()});
    for (const WalkTile& tile : space.tiles) {
        put_tile(out, fields, tile);
    }
    fields(space.starts, space.start_of);
}

WalkSpace take_space(ArchiveReader& in, ReportReader& fields, std::size_t objects) {
    constexpr std::size_t kMinTileBytes = 40;
    WalkSpace space{WalkGrid{}};
    fields(space.grid.cell, space.touched, space.bounds, space.ticks, space.strides);
    require(space.grid.cell >= kSmallestCell && space.touched.size() == objects, "it is of another campus");
    const std::size_t tiles = in.take_count(kMinTileBytes);
    for (std::size_t i = 0; i < tiles; ++i) {
        take_tile(in, fields, space);
    }
    check_chains(space);
    fields.require_nodes_of(space);
    fields(space.starts, space.start_of);
    require(space.start_of.size() == space.starts.size(), "its starts are incomplete");
    return space;
}

// ---- the report ---------------------------------------------------------------------------------------

void check_storeys(const WalkReport& report) {
    const Storeys& storeys = report.storeys;
    require(storeys.of_nodes.size() == report.space.tiles.size(), "its storeys are incomplete");
    for (std::size_t i = 0; i < storeys.of_nodes.size(); ++i) {
        require(storeys.of_nodes[i].size() == report.space.tiles[i].nodes.size() &&
                    std::ranges::all_of(storeys.of_nodes[i],
                                        [&](std::uint8_t storey) { return storey < storeys.list.size(); }),
                "its storeys are incomplete");
    }
}

void check_report(const WalkReport& report) {
    check_storeys(report);
    for (const SubjectReport& entry : report.subjects) {
        require(!entry.subject.island || *entry.subject.island < report.islands.size(),
                "an island in it is out of range");
    }
    for (const TriggerOverhang& overhang : report.overhangs) {
        require(overhang.storey < report.storeys.list.size(), "a storey in it is out of range");
    }
    for (const SeparateGround& ground : report.separate) {
        require(std::ranges::all_of(ground.starts,
                                    [&](std::uint32_t start) { return start < report.space.starts.size(); }),
                "a start in it is out of range");
    }
    const auto has_ground = [](const Island& island) { return !island.spots.empty(); };
    require(std::ranges::all_of(report.islands, has_ground, &IslandReport::island) &&
                std::ranges::all_of(report.narrow, has_ground, &NarrowPassage::beyond) &&
                std::ranges::none_of(report.holes, [](const Hole& hole) { return hole.edges.empty(); }),
            "a finding in it has no place");
}

}  // namespace

std::vector<std::byte> archive_report(const WalkReport& report) {
    ArchiveWriter out(kReportFile);
    FieldWriter fields(out);
    put_space(out, fields, report.space);
    each_field(fields, report);
    return scene::concatenated(out.finish());
}

WalkReport read_report_file(std::span<const std::byte> bytes, std::size_t objects) {
    ArchiveReader in(bytes, kReportFile);
    ReportReader fields(in, objects);
    WalkReport report{take_space(in, fields, objects)};
    each_field(fields, report);
    in.finish();
    check_report(report);
    return report;
}

}  // namespace campuswalk::engine
