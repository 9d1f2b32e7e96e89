#pragma once

#include <cstdint>

#include "engine/events/reason_fields.h"
#include "engine/walkspace/report/walk_report.h"

namespace campuswalk::engine {

// What is kept of a report and of what it consists of, in the order of the file. Writing and reading use the
// same lists, so that neither can miss a field.

constexpr std::uint32_t end_of(Gait /*gait*/) {
    return static_cast<std::uint32_t>(Gait::jump) + 1;
}
constexpr std::uint32_t end_of(Bound /*bound*/) {
    return kBoundNames.size();
}
constexpr std::uint32_t end_of(SubjectKind /*kind*/) {
    return kSubjectKindNames.size();
}

void each_field(auto& fields, MaybeConst<WalkNodeId> auto& id) {
    fields(id.tile, id.node);
}
void each_field(auto& fields, MaybeConst<GridCell> auto& cell) {
    fields(cell.x, cell.z);
}
void each_field(auto& fields, MaybeConst<GroundState> auto& at) {
    fields(at.foot, at.support_y);
}
void each_field(auto& fields, MaybeConst<Stride> auto& stride) {
    fields(stride.direction, stride.gait, stride.steering, stride.steers_after);
}
void each_field(auto& fields, MaybeConst<WalkTile::Keyframe> auto& keyframe) {
    fields(keyframe.node, keyframe.at);
}
void each_field(auto& fields, MaybeConst<WalkTile::FarParent> auto& parent) {
    fields(parent.node, parent.tile);
}
void each_field(auto& fields, MaybeConst<WalkTile::Drop> auto& drop) {
    fields(drop.node, drop.stride, drop.edge);
}
void each_field(auto& fields, MaybeConst<Storey> auto& storey) {
    fields(storey.low, storey.high, storey.area, storey.main_height);
}
void each_field(auto& fields, MaybeConst<Storeys> auto& storeys) {
    fields(storeys.list, storeys.of_nodes);
}
void each_field(auto& fields, MaybeConst<Subject> auto& subject) {
    fields(subject.kind, subject.name, subject.reached, subject.at, subject.node, subject.island,
           subject.reason, subject.walked_through);
}
void each_field(auto& fields, MaybeConst<SubjectReport> auto& entry) {
    fields(entry.subject, entry.distance);
}
void each_field(auto& fields, MaybeConst<UnreachedSpot> auto& spot) {
    fields(spot.at, spot.object, spot.triangle);
}
void each_field(auto& fields, MaybeConst<Island> auto& island) {
    fields(island.spots, island.bounds.min, island.bounds.max);
}
void each_field(auto& fields, MaybeConst<Barrier> auto& barrier) {
    fields(barrier.kind, barrier.measured, barrier.allowed, barrier.at, barrier.from, barrier.object,
           barrier.triangle, barrier.is_node, barrier.parts);
}
void each_field(auto& fields, MaybeConst<IslandReport> auto& entry) {
    fields(entry.island, entry.barrier, entry.hollow);
}
void each_field(auto& fields, MaybeConst<Trap> auto& trap) {
    fields(trap.nodes, trap.entrance, trap.edge, trap.drop, trap.out);
}
void each_field(auto& fields, MaybeConst<Hole::Edge> auto& edge) {
    fields(edge.node, edge.stride, edge.at);
}
void each_field(auto& fields, MaybeConst<Hole> auto& hole) {
    fields(hole.edges, hole.length);
}
void each_field(auto& fields, MaybeConst<NarrowPassage> auto& narrow) {
    fields(narrow.beyond, narrow.passage);
}
void each_field(auto& fields, MaybeConst<PassageSide> auto& side) {
    fields(side.object, side.at);
}
void each_field(auto& fields, MaybeConst<PassageWidth> auto& passage) {
    fields(passage.foot, passage.width, passage.sides[0], passage.sides[1]);
}
void each_field(auto& fields, MaybeConst<Bottleneck> auto& bottleneck) {
    fields(bottleneck.passage, bottleneck.is_only_path);
}
void each_field(auto& fields, MaybeConst<TriggerOverhang> auto& overhang) {
    fields(overhang.trigger, overhang.storey, overhang.foot, overhang.from_above, overhang.depth,
           overhang.also_in);
}
void each_field(auto& fields, MaybeConst<HotSpot> auto& spot) {
    fields(spot.foot, spot.pieces, spot.object);
}
void each_field(auto& fields, MaybeConst<SeparateGround> auto& ground) {
    fields(ground.starts, ground.area);
}
/// All but the space.
void each_field(auto& fields, MaybeConst<WalkReport> auto& report) {
    fields(report.storeys, report.subjects, report.islands, report.traps, report.holes, report.narrow,
           report.bottlenecks, report.overhangs, report.hot_spots, report.separate);
}

}  // namespace campuswalk::engine
