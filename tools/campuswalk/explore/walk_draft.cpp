#include "tools/campuswalk/explore/walk_draft.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/glob.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::fixed;

namespace {

constexpr int kWrittenDecimals = 5;
/// A spawn farther from where the body comes to stand was no good place, metres.
constexpr double kSamePlace = 0.05;

/// As it is read again from a walk file.
Vec3 as_written(const Vec3& p) {
    constexpr double kUnit = 1e5;  // kWrittenDecimals
    return (p * kUnit).array().round().matrix() / kUnit;
}

engine::Step step_of(const DraftStep& step) {
    const engine::Target target{list_of(step.to), as_written(step.to), true};
    switch (step.kind) {
        case DraftStep::Kind::walk_to: {
            engine::WalkToStep walk_to;
            walk_to.target = target;
            walk_to.speed = step.speed;
            walk_to.if_blocked = step.goes_on ? engine::IfBlocked::proceed : engine::IfBlocked::fail;
            return walk_to;
        }
        case DraftStep::Kind::go_to: {
            engine::GoToStep go_to;
            go_to.target = target;
            return go_to;
        }
        case DraftStep::Kind::wait:
            break;
    }
    engine::WaitStep wait;
    wait.seconds = step.seconds;
    return wait;
}

std::string yaml_of(const DraftStep& step) {
    switch (step.kind) {
        case DraftStep::Kind::walk_to: {
            const std::string speed = step.speed ? ", speed: " + fixed(*step.speed, kWrittenDecimals) : "";
            const std::string goes_on = step.goes_on ? ", if_blocked: continue" : "";
            return speed.empty() && goes_on.empty()
                       ? "walk_to: " + list_of(step.to)
                       : "walk_to: {to: " + list_of(step.to) + speed + goes_on + "}";
        }
        case DraftStep::Kind::go_to:
            return "go_to: " + list_of(step.to);
        case DraftStep::Kind::wait:
            break;
    }
    return "wait: " + fixed(step.seconds, 1);
}

class DraftWatch final : public engine::Observer {
public:
    explicit DraftWatch(const Vec3& spawn) : spawn_(spawn) {}

    void on_tick(const engine::TickRecord& record) override {
        const engine::AvatarState& avatar = record.avatar;
        if (record.tick == 0) {
            end_.stands_at_first = avatar.grounded && (avatar.position - spawn_).norm() <= kSamePlace;
        }
        if (avatar.grounded) {
            end_.stood = avatar.position;
        }
        end_.foot = avatar.position;
        end_.is_blocked =
            end_.is_blocked || std::ranges::find(record.events, engine::EventKind::avatar_blocked,
                                                 &engine::Event::kind) != record.events.end();
    }

    const DraftEnd& end_of_walk() const { return end_; }

private:
    Vec3 spawn_;
    DraftEnd end_;
};

}  // namespace

std::string list_of(const Vec3& p) {
    return "[" + fixed(p.x(), kWrittenDecimals) + ", " + fixed(p.y(), kWrittenDecimals) + ", " +
           fixed(p.z(), kWrittenDecimals) + "]";
}

std::string steps_yaml(const WalkDraft& draft, const std::vector<std::string>& disabled) {
    std::string yaml = "steps:\n  - spawn: {at: " + list_of(draft.spawn) + "}\n";
    for (std::size_t i = 0; i < disabled.size(); ++i) {
        yaml += (i == 0 ? "  - disable: [" : ", ") + json_text(disabled[i]);
    }
    yaml += disabled.empty() ? "" : "]\n";
    for (const DraftStep& step : draft.steps) {
        yaml += "  - " + yaml_of(step) + "\n";
    }
    return yaml;
}

DraftPlayer::DraftPlayer(const scene::Campus& campus, engine::AvatarProfile avatar,
                         std::vector<std::string> disabled)
    : campus_(campus), avatar_(std::move(avatar)), disabled_(std::move(disabled)) {}

std::vector<bool> DraftPlayer::disabled_objects() const {
    std::vector<bool> disabled;
    for (const scene::CampusObject& object : campus_.objects) {
        disabled.push_back(std::ranges::any_of(
            disabled_, [&](const std::string& glob) { return scene::glob_matches(glob, object.id); }));
    }
    return disabled;
}

DraftEnd DraftPlayer::play(const WalkDraft& draft) const {
    engine::Walk walk;
    walk.name = "draft";
    walk.avatar = avatar_;
    engine::SpawnStep spawn;
    spawn.label = list_of(draft.spawn);
    spawn.position = as_written(draft.spawn);
    walk.steps.emplace_back(spawn);
    if (!disabled_.empty()) {
        engine::EnableStep disable;
        disable.enabled = false;
        for (const std::string& glob : disabled_) {
            disable.objects.emplace_back().glob = glob;
        }
        walk.steps.emplace_back(disable);
    }
    for (const DraftStep& step : draft.steps) {
        walk.steps.push_back(step_of(step));
    }
    DraftWatch watch(spawn.position);
    const std::array<engine::Observer*, 1> observers{&watch};
    const engine::WalkSummary summary = engine::run_walk(campus_, walk, observers);
    DraftEnd end = watch.end_of_walk();
    end.failure = summary.failures.empty() ? "" : summary.failures.front().code;
    return end;
}

}  // namespace campuswalk::tools::explore
