#pragma once

#include <concepts>
#include <type_traits>

#include "engine/walkspace/report/walk_report.h"

namespace campuswalk::engine {

template <typename Struct, typename Plain>
concept MaybeConstOf = std::same_as<std::remove_const_t<Struct>, Plain>;

// What is kept of a report and of what it consists of, in the order of the file. Writing and reading use the
// same lists, so that neither can miss a field.

void each_field(auto& fields, MaybeConstOf<GridCell> auto& cell) {
    fields(cell.x, cell.z);
}
void each_field(auto& fields, MaybeConstOf<GroundState> auto& at) {
    fields(at.foot, at.support_y);
}
void each_field(auto& fields, MaybeConstOf<Stride> auto& stride) {
    fields(stride.direction, stride.gait, stride.steering, stride.steers_after);
}
void each_field(auto& fields, MaybeConstOf<WalkTile::Keyframe> auto& keyframe) {
    fields(keyframe.node, keyframe.at);
}
void each_field(auto& fields, MaybeConstOf<WalkTile::FarParent> auto& parent) {
    fields(parent.node, parent.tile);
}
void each_field(auto& fields, MaybeConstOf<WalkTile::Drop> auto& drop) {
    fields(drop.node, drop.stride, drop.edge);
}
void each_field(auto& fields, MaybeConstOf<Storey> auto& storey) {
    fields(storey.low, storey.high, storey.area, storey.main_height);
}
void each_field(auto& fields, MaybeConstOf<Storeys> auto& storeys) {
    fields(storeys.list, storeys.of_nodes);
}
void each_field(auto& fields, MaybeConstOf<Subject> auto& subject) {
    fields(subject.kind, subject.name, subject.reached, subject.at, subject.node, subject.island,
           subject.reason, subject.walked_through);
}
void each_field(auto& fields, MaybeConstOf<SubjectReport> auto& entry) {
    fields(entry.subject, entry.distance);
}
void each_field(auto& fields, MaybeConstOf<UnreachedSpot> auto& spot) {
    fields(spot.at, spot.object, spot.triangle);
}
void each_field(auto& fields, MaybeConstOf<Island> auto& island) {
    fields(island.spots, island.bounds.min, island.bounds.max);
}
void each_field(auto& fields, MaybeConstOf<Barrier> auto& barrier) {
    fields(barrier.kind, barrier.measured, barrier.allowed, barrier.at, barrier.from, barrier.object,
           barrier.triangle, barrier.is_node, barrier.parts);
}
void each_field(auto& fields, MaybeConstOf<IslandReport> auto& entry) {
    fields(entry.island, entry.barrier, entry.hollow);
}
void each_field(auto& fields, MaybeConstOf<Trap> auto& trap) {
    fields(trap.nodes, trap.entrance, trap.edge, trap.drop, trap.out);
}
void each_field(auto& fields, MaybeConstOf<Hole::Edge> auto& edge) {
    fields(edge.node, edge.stride, edge.at);
}
void each_field(auto& fields, MaybeConstOf<Hole> auto& hole) {
    fields(hole.edges, hole.length);
}
void each_field(auto& fields, MaybeConstOf<NarrowPassage> auto& narrow) {
    fields(narrow.beyond, narrow.passage);
}
void each_field(auto& fields, MaybeConstOf<PassageSide> auto& side) {
    fields(side.object, side.at);
}
void each_field(auto& fields, MaybeConstOf<PassageWidth> auto& passage) {
    fields(passage.foot, passage.width, passage.sides[0], passage.sides[1]);
}
void each_field(auto& fields, MaybeConstOf<Bottleneck> auto& bottleneck) {
    fields(bottleneck.passage, bottleneck.is_only_path);
}
void each_field(auto& fields, MaybeConstOf<TriggerOverhang> auto& overhang) {
    fields(overhang.trigger, overhang.storey, overhang.foot, overhang.from_above, overhang.depth,
           overhang.also_in);
}
void each_field(auto& fields, MaybeConstOf<HotSpot> auto& spot) {
    fields(spot.foot, spot.pieces, spot.object);
}
void each_field(auto& fields, MaybeConstOf<SeparateGround> auto& ground) {
    fields(ground.starts, ground.area);
}
/// All but the space.
void each_field(auto& fields, MaybeConstOf<WalkReport> auto& report) {
    fields(report.storeys, report.subjects, report.islands, report.traps, report.holes, report.narrow,
           report.bottlenecks, report.overhangs, report.hot_spots, report.separate);
}

}  // namespace campuswalk::engine
