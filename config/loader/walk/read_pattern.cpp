#include "config/loader/walk/read_pattern.h"

#include <algorithm>
#include <sstream>

#include "config/loader/values/names.h"
#include "config/loader/yaml/wording.h"
#include "engine/events/event.h"
#include "scene/base/glob.h"

namespace campuswalk::config {

engine::EventPattern read_pattern(const CheckedNode& node) {
    engine::EventPattern pattern;
    pattern.mark = node.mark();
    std::istringstream words(name_in(node).value_or(""));
    words >> pattern.kind;
    if (pattern.kind.empty()) {
        return pattern;  // line() has reported it
    }
    words >> pattern.object;
    if (std::string more; words >> more) {
        node.diagnose("bad-value", "an event is written KIND OBJECT, as in 'popup.open library'; remove " +
                                       in_quotes(more));
    }
    std::vector<std::string> kinds;
    for (const engine::EventKind kind : engine::event_kinds()) {
        kinds.emplace_back(name_of(kind));
    }
    const auto known = [&](const std::string& kind) { return scene::glob_matches(pattern.kind, kind); };
    if (std::ranges::none_of(kinds, known)) {
        node.diagnose("unknown-name",
                      "unknown event " + in_quotes(pattern.kind) + suggestion_or_list(pattern.kind, kinds));
    }
    return pattern;
}

}  // namespace campuswalk::config
