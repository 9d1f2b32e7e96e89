#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/loader/load_profile.h"
#include "engine/events/decimals.h"
#include "engine/script/mentions.h"
#include "engine/walkspace/route/campus_route.h"
#include "engine/walkspace/stride/tight_places.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/route/route_plan.h"
#include "tools/campuswalk/route/route_text.h"

namespace campuswalk::tools {

namespace {

struct RouteOptions {
    std::filesystem::path campus;
    std::string from;
    std::string to;
    std::string avatar = "adult";
    std::vector<std::string> through;
    engine::RoutePreference prefer = engine::RoutePreference::shortest;
    std::vector<std::string> disable;            ///< globs over objects
    std::optional<std::filesystem::path> write;  ///< a NAME.steps.yaml
    std::optional<std::filesystem::path> map;    ///< a picture
    bool json = false;
};

constexpr double kFarthest = 1e7;  // metres

std::optional<double> coordinate(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && end == text.data() + text.size() && std::isfinite(value) &&
                      std::abs(value) <= kFarthest;
    return good ? std::optional(value) : std::nullopt;
}

/// A place's or spawn's name (places first), "x,z" or "x,y,z". Throws bad-value or unknown-name about
/// `option`.
engine::Target parse_target(const scene::CampusDescription& campus, const std::string& text,
                            const std::string& option) {
    std::vector<std::string> names;
    for (const scene::Place& place : campus.places) {
        if (place.name == text) {
            return {text, place.position, place.has_height};
        }
        names.push_back(place.name);
    }
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == text) {
            return {text, spawn.position, true};
        }
        names.push_back(spawn.name);
    }
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() == 1) {
        throw scene::InputError(
            {option, 1, 1}, "unknown-name",
            "the campus has no place or spawn '" + text + "'" + scene::did_you_mean(text, names));
    }
    std::vector<double> numbers;
    for (const std::string_view part : parts) {
        if (const auto number = coordinate(part)) {
            numbers.push_back(*number);
        }
    }
    if (numbers.size() != parts.size() || numbers.size() > 3) {
        throw scene::InputError({option, 1, 1}, "bad-value",
                                "'" + text + "' is neither a name nor x,z nor x,y,z in metres");
    }
    const bool has_height = numbers.size() == 3;
    return {text, {numbers.front(), has_height ? numbers[1] : 0.0, numbers.back()}, has_height};
}

constexpr const char* kStepsSuffix = ".steps.yaml";

void check_outputs(const RouteOptions& options) {
    if (options.write) {
        if (!options.write->filename().string().ends_with(kStepsSuffix)) {
            throw scene::InputError({"--write", 1, 1}, "file-name",
                                    "steps are read from files named NAME" + std::string(kStepsSuffix));
        }
        require_writable_file(*options.write, "the steps can't be written here");
    }
    if (options.map) {
        if (!can_draw()) {
            throw scene::InputError({"--map", 1, 1}, "no-rendering", "this build can't draw plans");
        }
        require_writable_png(*options.map, "the plan can't be drawn here");
    }
}

engine::RouteRequest request_of(const RouteOptions& options, const scene::Campus& campus,
                                const engine::RouteSettings& settings, const collision::Vec3& start) {
    engine::RouteRequest request;
    for (const std::string& place : options.through) {
        request.to.push_back(parse_target(campus.description, place, "--through"));
    }
    request.to.push_back(parse_target(campus.description, options.to, "TO"));
    const auto body = engine::body_at(start, campus, settings);
    if (!body) {
        const bool has_height = parse_target(campus.description, options.from, "FROM").has_height;
        const std::string height = has_height
                                       ? "; start elsewhere"
                                       : ", at the first spawn's height of " + engine::fixed(start.y(), 2) +
                                             " m; start elsewhere, or say at which height: x,y,z";
        throw scene::InputError({"FROM", 1, 1}, "spawn-blocked",
                                "the avatar doesn't fit at " + options.from + height);
    }
    request.from = *body;
    return request;
}

void write_steps(const RouteOptions& options, const scene::Campus& campus,
                 const engine::AvatarProfile& avatar, const collision::Vec3& start,
                 const route::RouteAnswer& answer) {
    if (const std::string why = route::why_steps_fail(campus, avatar, start, answer, options.disable);
        !why.empty()) {
        throw std::runtime_error("this route can't be written as walk_to steps, use go_to: " + why);
    }
    scene::write_file_atomically(*options.write, route::steps_yaml(answer));
}

int find_route(const RouteOptions& options) {
    check_outputs(options);
    WalkLoader loader;
    const std::shared_ptr<const scene::Campus> campus = loader.load_campus(options.campus);
    if (options.map) {
        require_no_input(*options.map, files_of(*campus, options.campus), "the campus is read from");
    }
    const engine::AvatarProfile avatar = config::read_avatar_text(
        options.avatar, "--avatar", options.campus.parent_path(), campus->description, search_paths());
    const std::vector<bool> disabled = disabled_objects(*campus, options.disable);
    engine::RouteSettings settings = engine::route_settings(*campus, avatar, &disabled);
    if (options.prefer == engine::RoutePreference::wide) {
        settings.is_tight = engine::tight_places(campus->world, settings.solids, settings.strides.body);
    }
    const collision::Vec3 start =
        engine::route_start(parse_target(campus->description, options.from, "FROM"), campus->description);
    const engine::RouteRequest request = request_of(options, *campus, settings, start);

    route::RouteAnswer answer{options.from, options.to, {}, {}};
    auto found = engine::route_or_reason(*campus, settings, request);
    if (auto* route = std::get_if<engine::Route>(&found)) {
        answer.facts = engine::facts_of(*route, campus->world, settings.strides.body, settings.solids);
        answer.route = std::move(*route);
    } else {
        answer.why_not = std::get<engine::Reason>(std::move(found));
    }
    if (options.json) {
        print_lines(route::answer_json(answer));
    } else {
        route::print_answer(answer);
    }
    if (options.write && answer.route) {
        write_steps(options, *campus, avatar, start, answer);
    }
    if (options.map) {
        const auto plans =
            answer.route
                ? route::route_plans(*campus, settings, *answer.route, options.from, options.to)
                : route::barrier_plans(*campus, settings, request, *answer.why_not, options.from, options.to);
        draw_storey_plans(plans, *options.map);
    }
    return answer.route ? kPass : is_unknown(answer) ? kRunFailed : kExpectationFailed;
}

}  // namespace

void add_route(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<RouteOptions>();
    Command command = program.add("route", "Find the way from one place to another, or why there is none");
    command.option({.names = "CAMPUS", .help = "NAME.campus.yaml", .value = "FILE", .required = true},
                   options->campus);
    command.option({.names = "FROM",
                    .help = "A place, a spawn, x,z (at the height of the first spawn) or x,y,z",
                    .required = true},
                   options->from);
    command.option({.names = "TO", .help = "A place, a spawn, x,z or x,y,z", .required = true}, options->to);
    command.option({.names = "--avatar",
                    .help = "A profile, or as in a walk: '{profile: adult, step_height: 0.4}'",
                    .value = "AVATAR",
                    .show_default = true},
                   options->avatar);
    command.option({.names = "--through",
                    .help = "Pass there on the way; may be repeated, and is kept in order",
                    .value = "PLACE"},
                   options->through);
    command.choice<engine::RoutePreference>(
        {.names = "--prefer",
         .help = "wide: stretches with less than 0.4 m of room beside the avatar count four times"},
        {{"shortest", engine::RoutePreference::shortest}, {"wide", engine::RoutePreference::wide}},
        options->prefer);
    add_disable(command, options->disable);
    command.option({.names = "--write",
                    .help = "Write the route as steps that any walk may include: NAME.steps.yaml",
                    .value = "FILE"},
                   options->write);
    command.option({.names = "--map",
                    .help = "Draw a plan of it, or of what is in the way if there is none: NAME.png",
                    .value = "FILE"},
                   options->map);
    command.flag({.names = "--json", .help = "Print it for programs"}, options->json);
    add_import_options(command);
    add_root_option(command);
    command.footer(
        "Exit code: 0 there is a route, 1 there is none, 2 bad usage or input, 3 it can't be drawn or "
        "written, or\nisn't known.");
    command.choose(chosen, [options] { return find_route(*options); });
}

}  // namespace campuswalk::tools
