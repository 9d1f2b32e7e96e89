#include "engine/expect/popup_evaluators.h"

#include <algorithm>
#include <cmath>

#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

const std::string& text_field(const Event& event, std::string_view name) {
    static const std::string kNone;
    for (const Field& field : event.fields) {
        if (const auto* text = std::get_if<Text>(&field.value); text != nullptr && field.name == name) {
            return text->value;
        }
    }
    return kNone;
}

std::string described(const ExpectPopup& expected) {
    std::string words = "the pop-up of '" + expected.building.glob + "'";
    words += expected.title == "*" ? "" : " with the title '" + expected.title + "'";
    words += expected.body == "*" ? "" : " with the body '" + expected.body + "'";
    return words;
}

std::string what_was_said(const Event& event, double time, const std::string& title,
                          const std::string& body) {
    return "that of " + event.object + " " + at_time(time) + " had the title '" + title + "' and the body '" +
           body + "'";
}

bool has_popup(const scene::Campus& campus, std::size_t building) {
    return std::ranges::any_of(campus.objects, [&](const scene::CampusObject& object) {
        return object.popup && object.building == building;
    });
}

}  // namespace

// ---- popup ----------------------------------------------------------------------------------------------

void PopupEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    for (const Event& event : record.events) {
        if (event.kind != EventKind::popup_open ||
            !scene::glob_matches(expected_->building.glob, event.object)) {
            continue;
        }
        const std::string& title = text_field(event, "title");
        const std::string& body = text_field(event, "body");
        if (scene::glob_matches(expected_->title, title) && scene::glob_matches(expected_->body, body)) {
            ++times_;
        } else {
            other_ = what_was_said(event, record.time, title, body);
        }
        when_ = now;
    }
}

Finding PopupEvaluator::finding(bool /*ended*/) const {
    const std::string wanted = broken_limit(expected_->times, times_);
    std::string message = described(*expected_) + " opened " + told_times(times_);
    if (!wanted.empty()) {
        message += ", expected " + wanted + (other_.empty() ? "" : "; " + other_);
    }
    return {wanted.empty(), expected_->mark, message, when_, still_open(expected_->times, times_)};
}

// ---- visits ---------------------------------------------------------------------------------------------

VisitsEvaluator::VisitsEvaluator(const ExpectVisits& expected, const scene::Campus& campus)
    : expected_(&expected) {
    const std::vector<scene::Building>& buildings = campus.description.buildings;
    for (std::size_t i = 0; i < buildings.size(); ++i) {
        const bool meant = std::ranges::any_of(expected.buildings, [&](const NamePattern& pattern) {
            return scene::glob_matches(pattern.glob, buildings[i].id);
        });
        if (meant && has_popup(campus, i)) {
            mode_.push_back(buildings[i].id);
        }
    }
}

void VisitsEvaluator::see(const TickRecord& record, const StateSnapshot& /*now*/) {
    for (const Event& event : record.events) {
        if (event.kind == EventKind::popup_open && std::ranges::find(mode_, event.object) != mode_.end()) {
            visited_.insert(event.object);
        }
    }
}

Finding VisitsEvaluator::finding(bool /*ended*/) const {
    constexpr double kRounding = 1e-9;
    constexpr std::size_t kMostListed = 8;
    const auto needed =
        static_cast<std::size_t>(std::ceil(expected_->ratio * static_cast<double>(mode_.size()) - kRounding));
    std::string message = std::to_string(visited_.size()) + " of " + std::to_string(mode_.size()) +
                          (mode_.size() == 1 ? " building was visited" : " buildings were visited");
    if (visited_.size() >= needed) {
        return {true, expected_->mark, message, std::nullopt};
    }
    message += ", expected " + std::to_string(needed) + "; not visited: ";
    std::size_t listed = 0;
    for (const std::string& building : mode_) {
        if (!visited_.contains(building) && ++listed <= kMostListed) {
            message += (listed == 1 ? "" : ", ") + building;
        }
    }
    return {false, expected_->mark, message + (listed > kMostListed ? ", …" : ""), std::nullopt, true};
}

}  // namespace campuswalk::engine
