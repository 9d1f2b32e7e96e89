#include "engine/observers/text_log.h"

#include "engine/decimals.h"
#include "engine/events/event_text.h"

namespace campuswalk::engine {

void TextLog::begin(const Walk& walk) {
    sink_("# walk-log 1 walk=" + text_of_name(walk.name) + " campus=" + text_of_name(walk.campus_name) +
          " tps=" + std::to_string(walk.sim.ticks_per_second) + " seed=" + std::to_string(walk.sim.seed) +
          (walk.project.empty() ? "" : " project=" + text_of_name(walk.project)) +
          (walk.timeout ? " timeout=" + fixed(*walk.timeout, 3) : ""));
}

void TextLog::frame(const FrameRecord& record) {
    for (const Event& event : record.events) {
        sink_(text_line(event, record.time));
    }
}

}  // namespace campuswalk::engine
