#pragma once

#include "config/loader/checked_node.h"
#include "config/loader/step_context.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

// Each reads the value of a step's key; whatever is wrong has been complained of.

engine::Step read_spawn(const CheckedNode& node, StepContext& context);
engine::Step read_teleport(const CheckedNode& node, StepContext& context);
engine::Step read_walk_to(const CheckedNode& node, StepContext& context);
engine::Step read_follow(const CheckedNode& node, StepContext& context);
engine::Step read_turn(const CheckedNode& node, StepContext& context);
engine::Step read_look_at(const CheckedNode& node, StepContext& context);
engine::Step read_jump(const CheckedNode& node, StepContext& context);
engine::Step read_crouch(const CheckedNode& node, StepContext& context);
engine::Step read_run(const CheckedNode& node, StepContext& context);
engine::Step read_speed(const CheckedNode& node, StepContext& context);
engine::Step read_expect(const CheckedNode& node, StepContext& context);
engine::Step read_wait(const CheckedNode& node, StepContext& context);
engine::Step read_wait_until(const CheckedNode& node, StepContext& context);
engine::Step read_enable(const CheckedNode& node, StepContext& context);
engine::Step read_disable(const CheckedNode& node, StepContext& context);
engine::Step read_snapshot(const CheckedNode& node, StepContext& context);

}  // namespace campuswalk::config
