#pragma once

#include "config/loader/campus_names.h"
#include "config/loader/checked_node.h"
#include "engine/script/expectation.h"

namespace campuswalk::config {

// Each reads the value of an expectation's key; whatever is wrong has been complained of. Those that can do
// without a value are asked with an empty one when they stand alone, as in `- stuck`.

engine::PlainExpectation read_sequence(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_never(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_count(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_within(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_popup(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_visits(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_reaches(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_near(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_duration(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_distance(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_no_penetration(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_grounded(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_blocked_by(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_stuck(const CheckedNode& node, const CampusNames& names);
engine::PlainExpectation read_fell(const CheckedNode& node, const CampusNames& names);

}  // namespace campuswalk::config
