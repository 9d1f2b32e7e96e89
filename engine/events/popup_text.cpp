#include "engine/events/popup_text.h"

#include <algorithm>
#include <cstdint>

namespace campuswalk::engine {

namespace {

/// mm:ss; minutes may have more than two digits.
std::string clock_of(double seconds) {
    const auto whole = static_cast<std::int64_t>(seconds);
    const auto two_digits = [](std::int64_t value) {
        return (value < 10 ? "0" : "") + std::to_string(value);
    };
    return two_digits(whole / 60) + ":" + two_digits(whole % 60);
}

std::string value_of(const std::string& name, const scene::Building& building, const PopupFacts& facts,
                     bool in_title) {
    if (name == "id") {
        return building.id;
    }
    if (name == "kind") {
        return building.kind;
    }
    if (name == "hours") {
        return building.hours;
    }
    if (name == "floors") {
        return std::to_string(building.floors);
    }
    if (name == "visits") {
        return std::to_string(facts.visits);
    }
    if (name == "time") {
        return clock_of(facts.time);
    }
    if (name == "title") {
        return in_title ? "" : popup_title(building, facts);
    }
    const auto field = std::ranges::find(building.info, name, &scene::InfoField::name);
    return field == building.info.end() ? "" : field->value;
}

std::string filled_in(const std::string& text, const scene::Building& building, const PopupFacts& facts,
                      bool in_title) {
    const auto parts = text_parts(text);
    if (!parts) {
        return text;
    }
    std::string shown;
    for (const TextPart& part : *parts) {
        shown += part.is_variable ? value_of(part.text, building, facts, in_title) : part.text;
    }
    return shown;
}

}  // namespace

std::optional<std::vector<TextPart>> text_parts(const std::string& text) {
    std::vector<TextPart> parts(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool doubled = i + 1 < text.size() && text[i + 1] == text[i];
        if (text[i] != '{') {
            parts.back().text += text[i];
            i += text[i] == '}' && doubled ? 1U : 0U;
        } else if (doubled) {
            parts.back().text += '{';
            ++i;
        } else {
            const std::size_t end = text.find('}', i);
            if (end == std::string::npos) {
                return std::nullopt;
            }
            parts.push_back({true, text.substr(i + 1, end - i - 1), i});
            parts.emplace_back();
            i = end;
        }
    }
    return parts;
}

std::vector<std::string> popup_variables(const scene::Building& building) {
    std::vector<std::string> names = {"id", "title", "kind", "hours", "floors", "visits", "time"};
    for (const scene::InfoField& field : building.info) {
        names.push_back(field.name);
    }
    return names;
}

std::string popup_title(const scene::Building& building, const PopupFacts& facts) {
    return filled_in(building.title, building, facts, true);
}

std::string popup_text(const scene::Building& building, const PopupFacts& facts) {
    return filled_in(building.text, building, facts, false);
}

}  // namespace campuswalk::engine
