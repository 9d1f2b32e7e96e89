#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/expect/finding.h"
#include "engine/script/event_pattern.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

// Evaluators of expectations about which information windows open.

template <>
class EvaluatorOf<ExpectPopup> {
public:
    EvaluatorOf(const ExpectPopup& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        for (const Event& event : record.events) {
            if (event.kind != EventKind::popup_open ||
                !scene::glob_matches(expected_->building.glob, event.object)) {
                continue;
            }
            const std::string title = text_of(event, "title");
            const std::string body = text_of(event, "body");
            if (scene::glob_matches(expected_->title, title) && scene::glob_matches(expected_->body, body)) {
                ++times_;
            } else {
                other_ = "that of " + event.object + " " + at_time(record.time);
                other_.append(" had the title '").append(title);
                other_.append("' and the body '").append(body).append("'");
            }
            when_ = now;
        }
    }

    static PossibleVerdicts possible(const ExpectPopup& expected, const WalkBounds& bounds) {
        Interval times = bounds.times({expected.mark, std::string(name_of(EventKind::popup_open)), "*"});
        if (std::ranges::none_of(bounds.campus().description.buildings, [&](const scene::Building& building) {
                return scene::glob_matches(expected.building.glob, building.id) &&
                       can_show(building.title, expected.title) && can_show(building.text, expected.body);
            })) {
            times.most = 0.0;
        }
        return possible_verdicts(expected.times, times);
    }

    /// Variables are filled in when the window opens.
    static bool can_show(const std::string& text, const std::string& glob) {
        return text.find_first_of("{}") != std::string::npos || scene::glob_matches(glob, text);
    }

    Finding finding(bool /*ended*/) const {
        const std::string limit = violated_limit(expected_->times, times_);
        std::string message = "the pop-up of '" + expected_->building.glob + "'";
        message += expected_->title == "*" ? "" : " with the title '" + expected_->title + "'";
        message += expected_->body == "*" ? "" : " with the body '" + expected_->body + "'";
        message += " opened " + times_in_words(times_);
        return {.holds = limit.empty(),
                .mark = expected_->mark,
                .message = message,
                .when = when_,
                .can_change = can_still_change(expected_->times, times_),
                .expected = limit + (limit.empty() || other_.empty() ? "" : "; " + other_)};
    }

private:
    static std::string text_of(const Event& event, std::string_view field) {
        const Text* text = find_field<Text>(event, field);
        return text != nullptr ? text->value : "";
    }

    const ExpectPopup* expected_;
    int times_ = 0;
    std::string other_;  ///< the building's last pop-up with another title or body, in words
    std::optional<StateSnapshot> when_;
};

template <>
class EvaluatorOf<ExpectVisits> {
public:
    EvaluatorOf(const ExpectVisits& expected, const EvaluatorContext& context)
        : expected_(&expected), buildings_(pop_ups_of(expected, context.campus)) {}

    void on_tick(const TickRecord& record, const StateSnapshot& /*now*/) {
        for (const Event& event : record.events) {
            if (event.kind == EventKind::popup_open &&
                std::ranges::find(buildings_, event.object) != buildings_.end()) {
                visited_.insert(event.object);
            }
        }
    }

    static PossibleVerdicts possible(const ExpectVisits& expected, const WalkBounds& bounds) {
        return {.fails = needed(expected, pop_ups_of(expected, bounds.campus()).size()) > 0};
    }

    Finding finding(bool /*ended*/) const {
        constexpr std::size_t kMaxListed = 8;
        const std::size_t needed_visits = needed(*expected_, buildings_.size());
        std::string message = std::to_string(visited_.size()) + " of " + std::to_string(buildings_.size()) +
                              (buildings_.size() == 1 ? " building was visited" : " buildings were visited");
        if (visited_.size() >= needed_visits) {
            return {true, expected_->mark, message, std::nullopt};
        }
        std::string expected = std::to_string(needed_visits) + "; not visited: ";
        std::size_t listed = 0;
        for (const std::string& building : buildings_) {
            if (!visited_.contains(building) && ++listed <= kMaxListed) {
                expected += (listed == 1 ? "" : ", ") + building;
            }
        }
        return {.mark = expected_->mark,
                .message = message,
                .when = std::nullopt,
                .can_change = true,
                .expected = expected + (listed > kMaxListed ? ", …" : "")};
    }

private:
    static std::size_t needed(const ExpectVisits& expected, std::size_t buildings) {
        constexpr double kRounding = 1e-9;
        return static_cast<std::size_t>(
            std::ceil(expected.ratio * static_cast<double>(buildings) - kRounding));
    }

    static std::vector<std::string> pop_ups_of(const ExpectVisits& expected, const scene::Campus& campus) {
        std::vector<std::string> ids;
        const std::vector<scene::Building>& buildings = campus.description.buildings;
        for (std::size_t i = 0; i < buildings.size(); ++i) {
            if (matches_any(expected.buildings, buildings[i].id) && has_popup(campus, i)) {
                ids.push_back(buildings[i].id);
            }
        }
        return ids;
    }

    static bool has_popup(const scene::Campus& campus, std::size_t building) {
        return std::ranges::any_of(campus.objects, [&](const scene::CampusObject& object) {
            return object.popup && object.building == building;
        });
    }

    const ExpectVisits* expected_;
    std::vector<std::string> buildings_;  ///< in the campus' order
    std::set<std::string> visited_;       ///< of those
};

}  // namespace campuswalk::engine
