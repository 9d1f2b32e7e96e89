#include "engine/simulation/simulation_state.h"

namespace campuswalk::engine {

void name_obstacle(Stop& stop) {
    if (stop.reason) {
        stop.message += ": " + text_of(*stop.reason);
        stop.at = look_at(*stop.reason);
    } else if (!stop.object.empty()) {
        stop.message += ": blocked by " + stop.object;
    }
}

SimulationState::SimulationState(const scene::Campus& at, const Walk& played)
    : campus(at),
      walk(played),
      disabled(at.objects.size(), false),
      body(at, played, disabled),
      popups(at, played),
      contacts(at, played, disabled, popups),
      expectations(at, played) {}

const std::string& SimulationState::name_of(collision::ObjectId object) const {
    return campus.objects[index_of(object)].id;
}

void SimulationState::report_push(const Push& push, const std::string& label) {
    events.add(EventKind::avatar_depenetrated, label,
               {{"pos", body.foot()},
                {"from", push.from},
                {"distance", Decimal{push.distance, 3}},
                {"by", name_of(push.out_of)}});
}

TickRecord SimulationState::record() const {
    TickRecord record;
    record.tick = events.tick;
    record.time = walk.sim.seconds_at(events.tick);
    record.costs = costs;
    record.avatar = body.state();
    record.distance = body.distance();
    record.events = events.list;
    record.snapshots = snapshots;
    record.open_popups = popups.open();
    record.disabled = &disabled;
    return record;
}

}  // namespace campuswalk::engine
