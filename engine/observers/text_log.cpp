#include "engine/observers/text_log.h"

#include "engine/events/decimals.h"
#include "engine/events/event_text.h"

namespace campuswalk::engine {

namespace {

/// Empty if nothing is known.
std::string text_of(const scene::Origin& origin) {
    constexpr int kDegreeDigits = 8;  // a millimetre
    std::string text;
    if (origin.is_known()) {
        text += " origin=" + fixed(origin.at);
    }
    if (const auto& place = origin.geographic) {
        text += " latitude_deg=" + fixed(place->latitude_deg, kDegreeDigits) +
                " longitude_deg=" + fixed(place->longitude_deg, kDegreeDigits) +
                " height=" + fixed(place->height, 3);
        text += place->at.isZero(0.0) ? "" : " of=" + fixed(place->at);
    }
    return text;
}

}  // namespace

void TextLog::begin(const Walk& walk) {
    sink_("# walk-log 1 walk=" + text_of_name(walk.name) + " campus=" + text_of_name(walk.campus_name) +
          " tps=" + std::to_string(walk.sim.ticks_per_second) +
          (walk.project.empty() ? "" : " project=" + text_of_name(walk.project)) +
          (walk.timeout ? " timeout=" + fixed(*walk.timeout, 3) : "") + text_of(walk.origin));
}

void TextLog::on_tick(const TickRecord& record) {
    for (const Event& event : record.events) {
        sink_(text_line(event, record.time));
    }
}

}  // namespace campuswalk::engine
