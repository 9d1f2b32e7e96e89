#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/script/avatar.h"
#include "engine/script/failure_codes.h"
#include "engine/script/image_tolerance.h"
#include "engine/script/mentions.h"

// What is expected of a walk, as written below `expect` or in a step of that name. `kName` is the key in the
// file and the code of the failure; check_walk looks for what an expectation `mentions` on the campus.

namespace campuswalk::engine {

/// All that are set must hold.
template <typename Number>
struct Limits {
    std::optional<Number> equals;
    std::optional<Number> at_least;
    std::optional<Number> at_most;
};

// ---- events -------------------------------------------------------------------------------------------

struct ExpectSequence {
    static constexpr std::string_view kName = "sequence";
    SourceMark mark;
    std::vector<EventPattern> events;  ///< in this order; other events may come between

    std::vector<Mention> mentions() const {
        std::vector<Mention> all;
        for (const EventPattern& each : events) {
            all.push_back({each, ""});
        }
        return all;
    }
};

struct ExpectNever {
    static constexpr std::string_view kName = "never";
    SourceMark mark;
    EventPattern event;

    std::vector<Mention> mentions() const { return {{event, ""}}; }
};

struct ExpectCount {
    static constexpr std::string_view kName = "count";
    SourceMark mark;
    EventPattern event;
    Limits<int> times;

    std::vector<Mention> mentions() const { return {{event, ""}}; }
};

/// `after` comes, and each time `event` follows within `seconds`.
struct ExpectWithin {
    static constexpr std::string_view kName = "within";
    SourceMark mark;
    EventPattern after;
    EventPattern event;
    double seconds = 0.0;

    std::vector<Mention> mentions() const { return {{after, ""}, {event, ""}}; }
};

// ---- pop-ups ------------------------------------------------------------------------------------------

/// An information window opens.
struct ExpectPopup {
    static constexpr std::string_view kName = "popup";
    SourceMark mark;
    NamePattern building;
    std::string title = "*";  ///< glob
    std::string body = "*";   ///< glob, of the event's body: hours and text
    Limits<int> times{std::nullopt, 1, std::nullopt};

    std::vector<Mention> mentions() const { return {mention_of_popup(building)}; }
};

/// The pop-ups of these buildings open, each at least once. Buildings without one don't count.
struct ExpectVisits {
    static constexpr std::string_view kName = "visits";
    SourceMark mark;
    std::vector<NamePattern> buildings;  ///< at least one
    double ratio = 1.0;                  ///< at least, of those that match

    std::vector<Mention> mentions() const {
        std::vector<Mention> all;
        for (const NamePattern& each : buildings) {
            all.push_back(mention_of_popup(each));
        }
        return all;
    }
};

// ---- the path -----------------------------------------------------------------------------------------

/// The avatar reaches a point at some time.
struct ExpectReaches {
    static constexpr std::string_view kName = "reaches";
    SourceMark mark;
    Target target;
    double within = 0.5;  ///< metres; in three dimensions when the target has a height

    std::vector<Mention> mentions() const { return {}; }
};

/// The avatar is at a point at the end, or whenever an event comes, which must come at least once.
struct ExpectNear {
    static constexpr std::string_view kName = "near";
    SourceMark mark;
    Target target;
    double within = 0.5;  ///< metres, as in ExpectReaches
    std::optional<EventPattern> at;

    std::vector<Mention> mentions() const {
        return at ? std::vector<Mention>{{*at, ""}} : std::vector<Mention>();
    }
};

struct ExpectDuration {
    static constexpr std::string_view kName = "duration";
    SourceMark mark;
    Limits<double> seconds;  ///< simulated; equal if equal to the millisecond

    std::vector<Mention> mentions() const { return {}; }
};

struct ExpectDistance {
    static constexpr std::string_view kName = "distance";
    SourceMark mark;
    Limits<double> metres;  ///< along the path of the foot point; equal if equal to the millimetre

    std::vector<Mention> mentions() const { return {}; }
};

// ---- the campus ---------------------------------------------------------------------------------------

/// A visitor who is put down at one target can walk to the other, whatever this walk does.
struct ExpectReachable {
    static constexpr std::string_view kName = "reachable";
    SourceMark mark;
    Target from;
    Target to;
    std::optional<AvatarProfile> avatar = {};  ///< of that visitor; none: the walk's

    std::vector<Mention> mentions() const { return {}; }
};

/// There is a route, and it is like this; see Route and RouteFacts.
struct ExpectRoute {
    static constexpr std::string_view kName = "route";
    SourceMark mark;
    Target from;
    Target to;
    std::optional<AvatarProfile> avatar = {};  ///< as of ExpectReachable
    std::optional<double> max_length;          ///< metres
    std::optional<double> min_width;           ///< metres, less than RouteFacts::kWidest
    std::optional<double> max_slope;           ///< radians

    std::vector<Mention> mentions() const { return {}; }
};

// ---- the body -----------------------------------------------------------------------------------------

/// At the end of each tick the body is outside all solids, but for those of layers that it ignores.
struct ExpectNoPenetration {
    static constexpr std::string_view kName = "no_penetration";
    SourceMark mark;
    double tolerance = 1e-4;  ///< metres

    std::vector<Mention> mentions() const { return {}; }
};

struct ExpectGrounded {
    static constexpr std::string_view kName = "grounded";
    SourceMark mark;
    double ratio = 1.0;  ///< at least, of the ticks

    std::vector<Mention> mentions() const { return {}; }
};

/// Something blocks the avatar: it ends a walk_to or follow, or the avatar is stuck at it.
struct ExpectBlockedBy {
    static constexpr std::string_view kName = "blocked_by";
    SourceMark mark;
    NamePattern object;

    std::vector<Mention> mentions() const { return {mention_of_solid(object)}; }
};

struct ExpectStuck {
    static constexpr std::string_view kName = "stuck";
    SourceMark mark;
    NamePattern by;  ///< `*`: by anything, even if it has no name

    std::vector<Mention> mentions() const { return {mention_of_solid(by)}; }
};

struct ExpectFell {
    static constexpr std::string_view kName = "fell";
    SourceMark mark;

    std::vector<Mention> mentions() const { return {}; }
};

// ---- all of them --------------------------------------------------------------------------------------

using PlainExpectation =
    std::variant<ExpectSequence, ExpectNever, ExpectCount, ExpectWithin, ExpectPopup, ExpectVisits,
                 ExpectReaches, ExpectNear, ExpectDuration, ExpectDistance, ExpectNoPenetration,
                 ExpectGrounded, ExpectBlockedBy, ExpectStuck, ExpectFell, ExpectReachable, ExpectRoute>;

/// That an expectation doesn't hold. The failure's code is `not-` and the expectation's name.
struct ExpectNot {
    static constexpr std::string_view kName = "not";
    SourceMark mark;
    PlainExpectation what;
};

/// The event log equals, to the byte, the one that is stored beside the walk. Evaluated after the run,
/// where the files are; a step can't expect it.
struct ExpectLog {
    static constexpr std::string_view kName = "log";
    SourceMark mark;
    bool golden = true;
};

// ---- images -----------------------------------------------------------------------------------------
// Evaluated after the run, where the walk's snapshots are drawn: drawing differs between machines, and the
// verdict on an image changes neither the walk nor its log. A step can't expect these.

/// A snapshot equals, within a tolerance, the image that is stored beside the walk.
struct ExpectSnapshot {
    static constexpr std::string_view kName = "snapshot";
    SourceMark mark;
    std::string name;            ///< of a snapshot step
    ToleranceChanges tolerance;  ///< to the tolerance of all of a run's snapshots
};

/// A building is visible in a snapshot. Windows and maps drawn over it hide nothing.
struct ExpectVisible {
    static constexpr std::string_view kName = "visible";
    SourceMark mark;
    NamePattern building;
    SourceMark snapshot_mark;
    std::string snapshot;             ///< name of a snapshot step
    int min_pixels = 1;               ///< at least
    std::optional<double> min_ratio;  ///< at least, of the image's pixels
    bool negated = false;             ///< `not`: less of it is visible
};

/// The code of its failure: `not-` and its name if it is negated.
std::string code_of(const ExpectVisible& expected);

using Expectation = std::variant<PlainExpectation, ExpectNot, ExpectLog, ExpectSnapshot, ExpectVisible>;

/// What is evaluated during the walk: the expectation itself or the one that `not` negates. Null for those
/// that are evaluated afterwards: logs and images.
const PlainExpectation* plain_part(const Expectation& expectation);
/// What those name, in their order.
std::vector<Mention> mentions_of(const std::vector<Expectation>& expectations);

/// Whether it can be evaluated only where images are drawn.
bool is_about_images(const Expectation& expectation);
/// The failure codes of those.
std::vector<std::string> image_failure_codes();

/// Whether it is one of kLackCodes.
bool is_lack(std::string_view code);

/// The codes that a status can expect: kStopCodes, the names above, and the same with `not-` before them.
std::vector<std::string> failure_codes();

}  // namespace campuswalk::engine
