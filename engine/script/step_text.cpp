#include "engine/script/step_text.h"

#include <algorithm>

#include "engine/events/decimals.h"

namespace campuswalk::engine {

namespace {

/// As few decimals as tell it, three at most.
std::string few_decimals(double value) {
    std::string text = fixed(value, 3);
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

std::string patterns(const std::vector<NamePattern>& names) {
    std::string text;
    for (const NamePattern& name : names) {
        text += (text.empty() ? "" : ", ") + name.glob;
    }
    return text;
}

// One for each kind of step: a kind without one doesn't compile.

std::string words_of(const SpawnStep& step) {
    return "spawn: " + step.label;
}
std::string words_of(const WalkToStep& step) {
    return "walk_to: " + step.target.label;
}
std::string words_of(const GoToStep& step) {
    return "go_to: " + step.target.label;
}
std::string words_of(const FollowStep& step) {
    return "follow: " + std::to_string(step.points.size()) + (step.points.size() == 1 ? " point" : " points");
}
std::string words_of(const WaitStep& step) {
    return "wait: " + few_decimals(step.seconds);
}
std::string words_of(const WaitUntilStep& step) {
    return "wait_until: " + step.event.kind + (step.event.object == "*" ? "" : " " + step.event.object);
}
std::string words_of(const TurnStep& step) {
    return (step.absolute ? "turn to: " : "turn: ") + few_decimals(degrees(step.angle));
}
std::string words_of(const LookAtStep& step) {
    return "look_at: " + step.target.label;
}
std::string words_of(const TeleportStep& step) {
    return "teleport: " + step.label;
}
std::string words_of(const JumpStep&) {
    return "jump";
}
std::string words_of(const SnapshotStep& step) {
    return "snapshot: " + step.name;
}
std::string words_of(const CrouchStep& step) {
    return "crouch: " + few_decimals(step.height);
}
std::string words_of(const SpeedStep& step) {
    return "speed: " + few_decimals(step.speed);
}
std::string words_of(const EnableStep& step) {
    return (step.enabled ? "enable: " : "disable: ") + patterns(step.objects);
}
std::string words_of(const ExpectStep&) {
    return "expect";
}

}  // namespace

std::string text_of(const Step& step) {
    return std::visit([](const auto& each) { return words_of(each); }, step);
}

}  // namespace campuswalk::engine
