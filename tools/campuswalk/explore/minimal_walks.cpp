#include "tools/campuswalk/explore/minimal_walks.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "scene/base/glob.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/explore/barrier_walks.h"
#include "tools/campuswalk/explore/earlier_files.h"
#include "tools/campuswalk/explore/one_way_walks.h"

namespace campuswalk::tools::explore {

using engine::WalkReport;

namespace {

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
            case FindingKind::stuck: {
                const auto trap = std::ranges::find(report_.traps, *finding.at, &engine::Trap::edge);
                return yaml_if_shown(finding, walk_into_trap(report_, *trap, players_.usual, starts_),
                                     players_.usual);
            }
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
        const auto narrow = std::ranges::find_if(report_.narrow, [&](const engine::NarrowPassage& entry) {
            return entry.passage && entry.passage->at == *finding.at;
        });
        return narrow == report_.narrow.end()
                   ? std::nullopt
                   : of_barrier(finding, *narrow->passage, narrow->beyond, players_.wide);
    }

    std::string of_trigger(const Finding& finding) const {
        const WalkDraft draft{*finding.at, {{.kind = DraftStep::Kind::wait, .seconds = 0.1}}};
        return status_yaml(finding, "never") + steps_yaml(draft, players_.usual.disabled()) +
               "expect:\n  - never: " + json_text("trigger.enter " + scene::glob_for(finding.trigger)) + "\n";
    }

    std::optional<std::string> of_hole(const Finding& finding) {
        const auto hole = std::ranges::find_if(
            report_.holes, [&](const engine::Hole& h) { return h.edges.front().at == *finding.at; });
        const auto walk = walk_into_hole(*hole, players_.usual, starts_);
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
                                 "take away `status`.\ncampus: " + json_text(header.campus) + "\navatar: " +
                                 (finding.kind == FindingKind::narrow ? header.wide_avatar : header.avatar) +
                                 "\n" + *steps});
        }
    }
    return walks;
}

}  // namespace campuswalk::tools::explore
