#include "tools/campuswalk/explore/minimal_walks.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

#include "engine/script/failure_codes.h"
#include "engine/script/travel.h"
#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/route/campus_route.h"
#include "scene/base/glob.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/explore/earlier_files.h"
#include "tools/campuswalk/explore/one_way_walks.h"
#include "tools/campuswalk/explore/walk_starts.h"

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::ReasonKind;
using engine::WalkReport;

namespace {

/// A visitor, and what isn't in the way.
struct Mended {
    engine::AvatarProfile avatar;
    std::vector<std::string> disabled;
};

/// Changes it so that the barrier is none. False if no single change does that.
bool mend(const scene::Campus& campus, const engine::Barrier& barrier, Mended& mended) {
    constexpr double kSlack = 0.02;       // metres
    constexpr double kSlopeSlack = 0.01;  // radians
    engine::AvatarProfile& avatar = mended.avatar;
    switch (barrier.kind) {
        case ReasonKind::riser:
            avatar.step_height = std::max(avatar.step_height, barrier.measured + kSlack);
            return true;
        case ReasonKind::slope:
            avatar.max_slope = std::max(avatar.max_slope, barrier.measured + kSlopeSlack);
            return true;
        case ReasonKind::opening:
            avatar.radius = std::min(avatar.radius, 0.5 * (barrier.measured - kSlack));
            return true;
        case ReasonKind::headroom:
            avatar.height = std::min(avatar.height, barrier.measured - kSlack);
            return true;
        case ReasonKind::object:
            if (!barrier.object || barrier.is_node) {
                return false;
            }
            mended.disabled.push_back(scene::glob_for(campus.objects[index_of(*barrier.object)].id));
            return true;
        case ReasonKind::sequence:
            return std::ranges::all_of(
                barrier.parts, [&](const engine::Barrier& part) { return mend(campus, part, mended); });
        default:
            return false;
    }
}

/// The visitor for whom the barrier is none, or who goes where it isn't: as on the campus once it is mended.
std::optional<DraftPlayer> unhindered(const DraftPlayer& player, const engine::Barrier& barrier) {
    Mended mended{player.avatar(), player.disabled()};
    if (!mend(player.campus(), barrier, mended)) {
        return std::nullopt;
    }
    return DraftPlayer(player.campus(), std::move(mended.avatar), std::move(mended.disabled));
}

/// No way that is longer mends anything.
constexpr std::size_t kMostNodes = 20'000;

class BarrierWalker {
public:
    BarrierWalker(const engine::Barrier& barrier, const Vec3& goal, const DraftPlayer& player,
                  WalkStarts& starts)
        : barrier_(barrier), goal_(goal), player_(player), mended_(unhindered(player, barrier)) {
        for (const auto& start :
             starts.before(barrier.from, engine::flat(goal - barrier.from).normalized())) {
            from_.push_back(start.foot);
        }
        from_.push_back(barrier.from);
    }

    /// Straight on, if that gets there once the barrier is away; else by whatever way then leads there.
    std::optional<ShownWalk> straight_or_round() const {
        std::optional<ShownWalk> straight;
        for (const Vec3& start : from_) {
            if (auto shown = straight_from(start)) {
                straight = shown;
                if (passes_mended(shown->draft)) {
                    return straight;
                }
            }
        }
        const auto round = by_route();
        return round ? round : straight;
    }

    /// By a go_to: no way leads there, as the report has found.
    std::optional<ShownWalk> by_route() const {
        for (const Vec3& start : from_) {
            if (!player_.play({start, {}}).stands_at_first) {
                continue;
            }
            const ShownWalk walk{{start, {{.kind = DraftStep::Kind::go_to, .to = goal_}}},
                                 std::string(engine::kUnreachableCode),
                                 goal_};
            return !mended_ || has_route(*mended_, start) ? std::optional(walk) : std::nullopt;
        }
        return std::nullopt;
    }

private:
    std::optional<ShownWalk> straight_from(const Vec3& start) const {
        constexpr double kAtBarrier = 1.0;  // metres
        const ShownWalk walk{{start, {{.to = goal_}}}, std::string(engine::kBlockedCode), goal_};
        const DraftEnd end = player_.play(as_tried(walk.draft));
        return end.stands_at_first && end.is_blocked && end.failure.empty() &&
                       (end.foot - barrier_.from).norm() <= kAtBarrier
                   ? std::optional(walk)
                   : std::nullopt;
    }

    bool has_route(const DraftPlayer& player, const Vec3& start) const {
        const std::vector<bool> disabled = player.disabled_objects();
        engine::RouteSettings settings = engine::route_settings(player.campus(), player.avatar(), &disabled);
        settings.max_nodes = kMostNodes;
        const auto body = engine::body_at(start, player.campus(), settings);
        return body && std::holds_alternative<engine::Route>(engine::plan_route(
                           player.campus().world, settings, {*body, {{list_of(goal_), goal_, true}}}));
    }

    /// Without a failure's search for a way round.
    static WalkDraft as_tried(WalkDraft draft) {
        draft.steps.front().goes_on = true;
        return draft;
    }

    /// Returns true as well where no way to mend the barrier is known.
    bool passes_mended(const WalkDraft& draft) const {
        if (!mended_) {
            return true;
        }
        const DraftEnd end = mended_->play(as_tried(draft));
        return end.failure.empty() && !end.is_blocked;
    }

    const engine::Barrier& barrier_;
    const Vec3 goal_;
    const DraftPlayer& player_;
    const std::optional<DraftPlayer> mended_;
    std::vector<Vec3> from_;
};

/// From ground before the barrier to `goal`, feet, on what isn't reached: straight on, `blocked` until the
/// barrier is away, or where that leads elsewhere by a go_to, `unreachable` until then. None if no such walk
/// shows it.
std::optional<ShownWalk> walk_at_barrier(const engine::Barrier& barrier, const Vec3& goal,
                                         const DraftPlayer& player, WalkStarts& starts) {
    return BarrierWalker(barrier, goal, player, starts).straight_or_round();
}

/// Shows the barrier by a go_to rather than a walk_to if one does: for what somebody wants to get to,
/// whichever route leads there one day.
std::optional<ShownWalk> walk_to_goal(const engine::Barrier& barrier, const Vec3& goal,
                                      const DraftPlayer& player, WalkStarts& starts) {
    const BarrierWalker walker(barrier, goal, player, starts);
    const auto walk = walker.by_route();
    return walk ? walk : walker.straight_or_round();
}

/// The finding's number, kind and name: letters, digits and dashes.
std::string file_name(std::size_t number, const Finding& finding) {
    const std::string digits = std::to_string(number);
    std::string name = (digits.size() < 2 ? "0" : "") + digits + "-" + name_of(finding.kind) + "-";
    constexpr std::size_t kLongest = 60;
    for (const char c : finding.subject) {
        if (name.size() >= kLongest || c == ',') {
            break;
        }
        const bool plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
        if (plain) {
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (name.back() != '-') {
            name += '-';
        }
    }
    while (name.back() == '-') {
        name.pop_back();
    }
    return name;
}

std::string status_yaml(const Finding& finding, const std::string& failures) {
    return "status: {is: xfail, because: " + json_text(finding.text) + ", failures: [" + failures + "]}\n";
}

/// The last step fails until it gets where it goes. Until then nothing else is expected, as nothing else
/// would be decided.
std::string yaml_of(const Finding& finding, const ShownWalk& walk, const DraftPlayer& player) {
    return status_yaml(finding, walk.failure) + steps_yaml(walk.draft, player.disabled()) +
           "# Once it is mended:\n# expect: [{reaches: {place: " + list_of(walk.goal) + ", within: 0.5}}]\n";
}

class MinimalWalks {
public:
    MinimalWalks(const WalkReport& report, const WalkPlayers& players)
        : report_(report), players_(players), starts_(report, players.strider) {}

    std::optional<std::string> yaml_of(const Finding& finding) {
        switch (finding.kind) {
            case FindingKind::unreached:
            case FindingKind::island:
                return of_island(finding);
            case FindingKind::narrow:
                return of_narrow_passage(finding);
            case FindingKind::popup:  // there is nothing to try
            case FindingKind::hot:    // a walk tells no costs
                return std::nullopt;
            case FindingKind::trigger:
                return of_trigger(finding);
            case FindingKind::trap:
            case FindingKind::stuck:
                return yaml_if_shown(
                    finding, walk_into_trap(report_, report_.traps[*finding.index], players_.usual, starts_),
                    players_.usual);
            case FindingKind::hole:
                return of_hole(finding);
        }
        return std::nullopt;
    }

private:
    static std::optional<std::string> yaml_if_shown(const Finding& finding,
                                                    const std::optional<ShownWalk>& walk,
                                                    const DraftPlayer& player) {
        return walk ? std::optional(explore::yaml_of(finding, *walk, player)) : std::nullopt;
    }

    std::optional<std::string> of_barrier(const Finding& finding, const engine::Barrier& barrier,
                                          const engine::Island& beyond, const DraftPlayer& player) {
        if (barrier.kind == engine::ReasonKind::solid) {
            return std::nullopt;
        }
        const auto walk = finding.kind == FindingKind::unreached ? walk_to_goal : walk_at_barrier;
        return yaml_if_shown(finding, walk(barrier, beyond.nearest_to(barrier.from), player, starts_),
                             player);
    }

    std::optional<std::string> of_island(const Finding& finding) {
        return finding.islands.empty() || !finding.barrier
                   ? std::nullopt
                   : of_barrier(finding, *finding.barrier, report_.islands[finding.islands.front()].island,
                                players_.usual);
    }

    std::optional<std::string> of_narrow_passage(const Finding& finding) {
        return finding.barrier ? of_barrier(finding, *finding.barrier, report_.narrow[*finding.index].beyond,
                                            players_.wide)
                               : std::nullopt;
    }

    std::string of_trigger(const Finding& finding) const {
        const WalkDraft draft{*finding.at, {{.kind = DraftStep::Kind::wait, .seconds = 0.1}}};
        return status_yaml(finding, "never") + steps_yaml(draft, players_.usual.disabled()) +
               "expect:\n  - never: " + json_text("trigger.enter " + scene::glob_for(finding.trigger)) + "\n";
    }

    std::optional<std::string> of_hole(const Finding& finding) {
        const auto walk = walk_into_hole(report_.holes[*finding.index], players_.usual, starts_);
        return walk ? std::optional(status_yaml(finding, walk->failure + ", never") +
                                    steps_yaml(walk->draft, players_.usual.disabled()) +
                                    "expect:\n  - never: \"avatar.fell *\"\n")
                    : std::nullopt;
    }

    const WalkReport& report_;
    const WalkPlayers& players_;
    WalkStarts starts_;
};

}  // namespace

std::vector<MinimalWalk> minimal_walks(const WalkReport& report, const std::vector<Finding>& findings,
                                       const WalkHeader& header, const WalkPlayers& players) {
    MinimalWalks drafts(report, players);
    std::vector<MinimalWalk> walks;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& finding = findings[i];
        if (const auto steps = drafts.yaml_of(finding)) {
            walks.push_back({file_name(i + 1, finding),
                             "# Finding " + std::to_string(i + 1) + kWalkHeading + "Once it is mended, " +
                                 "take away `status`.\n" + header.schema_line +
                                 "campus: " + json_text(header.campus) + "\navatar: " +
                                 (finding.kind == FindingKind::narrow ? header.wide_avatar : header.avatar) +
                                 "\n" + *steps});
        }
    }
    return walks;
}

}  // namespace campuswalk::tools::explore
