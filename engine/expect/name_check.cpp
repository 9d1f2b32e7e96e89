#include "engine/expect/name_check.h"

#include <string>

namespace campuswalk::engine {

using scene::Diagnostic;

namespace {

Diagnostic unknown(const SourceMark& mark, const std::string& message) {
    return {scene::Severity::error, mark, "unknown-name", message};
}

/// What an expectation names, each kind in its own way; the places have been looked up by the loader.
class Mentions {
public:
    Mentions(const NameCheck& names, const EventSubjects& subjects, std::vector<Diagnostic>& diagnostics)
        : names_(names), subjects_(subjects), diagnostics_(diagnostics) {}

    void check(const ExpectSequence& expected) const {
        for (const EventPattern& event : expected.events) {
            names_.check(event, diagnostics_);
        }
    }
    void check(const ExpectNever& expected) const { names_.check(expected.event, diagnostics_); }
    void check(const ExpectCount& expected) const { names_.check(expected.event, diagnostics_); }
    void check(const ExpectWithin& expected) const {
        names_.check(expected.after, diagnostics_);
        names_.check(expected.event, diagnostics_);
    }
    void check(const ExpectNear& expected) const {
        if (expected.at) {
            names_.check(*expected.at, diagnostics_);
        }
    }
    void check(const ExpectPopup& expected) const { check_building(expected.building); }
    void check(const ExpectVisits& expected) const {
        for (const NamePattern& building : expected.buildings) {
            check_building(building);
        }
    }
    void check(const ExpectBlockedBy& expected) const { check_solid(expected.object); }
    void check(const ExpectStuck& expected) const { check_solid(expected.by); }
    // These name nothing.
    void check(const ExpectReaches&) const {}
    void check(const ExpectDuration&) const {}
    void check(const ExpectDistance&) const {}
    void check(const ExpectNoPenetration&) const {}
    void check(const ExpectGrounded&) const {}
    void check(const ExpectFell&) const {}

private:
    void check_building(const NamePattern& building) const {
        check_name(building, "popup.open", "no building '" + building.glob + "' has a pop-up");
    }
    void check_solid(const NamePattern& object) const {
        check_name(object, "collision.enter", "the campus has no solid object '" + object.glob + "'");
    }
    void check_name(const NamePattern& name, const std::string& kind, const std::string& message) const {
        const EventPattern event{name.mark, kind, name.glob};
        if (!subjects_.can_happen(event)) {
            diagnostics_.push_back(
                unknown(name.mark, message + scene::did_you_mean(name.glob, subjects_.names(event))));
        }
    }

    const NameCheck& names_;
    const EventSubjects& subjects_;
    std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

void NameCheck::check(const EventPattern& pattern, std::vector<Diagnostic>& diagnostics) const {
    if (!subjects_.can_happen(pattern)) {
        diagnostics.push_back(
            unknown(pattern.mark, "'" + pattern.kind + " " + pattern.object +
                                      "' can't happen: nothing of that name has such events" +
                                      scene::did_you_mean(pattern.object, subjects_.names(pattern))));
    }
}

void NameCheck::check(const std::vector<Expectation>& expectations,
                      std::vector<Diagnostic>& diagnostics) const {
    const Mentions mentions(*this, subjects_, diagnostics);
    const auto check_plain = [&](const PlainExpectation& plain) {
        std::visit([&](const auto& expected) { mentions.check(expected); }, plain);
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
