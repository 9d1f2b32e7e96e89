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

    Finding finding(bool /*ended*/) const {
        const std::string limit = violated_limit(expected_->times, times_);
        std::string message = "the pop-up of '" + expected_->building.glob + "'";
        message += expected_->title == "*" ? "" : " with the title '" + expected_->title + "'";
        message += expected_->body == "*" ? "" : " with the body '" + expected_->body + "'";
        message += " opened " + times_in_words(times_);
        if (!limit.empty()) {
            message += ", expected " + limit + (other_.empty() ? "" : "; " + other_);
        }
        return {limit.empty(), expected_->mark, message, when_, can_still_change(expected_->times, times_)};
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
    EvaluatorOf(const ExpectVisits& expected, const EvaluatorContext& context) : expected_(&expected) {
        const std::vector<scene::Building>& buildings = context.campus.description.buildings;
        for (std::size_t i = 0; i < buildings.size(); ++i) {
            if (matches_any(expected.buildings, buildings[i].id) && has_popup(context.campus, i)) {
                buildings_.push_back(buildings[i].id);
            }
        }
    }

    void on_tick(const TickRecord& record, const StateSnapshot& /*now*/) {
        for (const Event& event : record.events) {
            if (event.kind == EventKind::popup_open &&
                std::ranges::find(buildings_, event.object) != buildings_.end()) {
                visited_.insert(event.object);
            }
        }
    }

    Finding finding(bool /*ended*/) const {
        constexpr double kRounding = 1e-9;
        constexpr std::size_t kMaxListed = 8;
        const auto needed = static_cast<std::size_t>(
            std::ceil(expected_->ratio * static_cast<double>(buildings_.size()) - kRounding));
        std::string message = std::to_string(visited_.size()) + " of " + std::to_string(buildings_.size()) +
                              (buildings_.size() == 1 ? " building was visited" : " buildings were visited");
        if (visited_.size() >= needed) {
            return {true, expected_->mark, message, std::nullopt};
        }
        message += ", expected " + std::to_string(needed) + "; not visited: ";
        std::size_t listed = 0;
        for (const std::string& building : buildings_) {
            if (!visited_.contains(building) && ++listed <= kMaxListed) {
                message += (listed == 1 ? "" : ", ") + building;
            }
        }
        return {false, expected_->mark, message + (listed > kMaxListed ? ", …" : ""), std::nullopt, true};
    }

private:
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
