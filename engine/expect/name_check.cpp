#include "engine/expect/name_check.h"

#include <string>

namespace campuswalk::engine {

using scene::Diagnostic;

void NameCheck::check(const Mention& mention, std::vector<Diagnostic>& diagnostics) const {
    const EventPattern& event = mention.event;
    if (subjects_.can_happen(event)) {
        return;
    }
    const std::string fault =
        !mention.if_unknown.empty()
            ? mention.if_unknown
            : "'" + event.kind + " " + event.object + "' can't happen: nothing of that name has such events";
    diagnostics.push_back({scene::Severity::error, event.mark, "unknown-name",
                           fault + scene::did_you_mean(event.object, subjects_.names(event))});
}

void NameCheck::check(const EventPattern& pattern, std::vector<Diagnostic>& diagnostics) const {
    check(Mention{pattern, ""}, diagnostics);
}

void NameCheck::check(const std::vector<Expectation>& expectations,
                      std::vector<Diagnostic>& diagnostics) const {
    const auto check_plain = [&](const PlainExpectation& plain) {
        for (const Mention& mention : std::visit([](const auto& each) { return each.mentions(); }, plain)) {
            check(mention, diagnostics);
        }
    };
    for (const Expectation& expectation : expectations) {
        if (const auto* plain = std::get_if<PlainExpectation>(&expectation)) {
            check_plain(*plain);
        } else if (const auto* negation = std::get_if<ExpectNot>(&expectation)) {
            check_plain(negation->what);
        }
    }
}

}  // namespace campuswalk::engine
