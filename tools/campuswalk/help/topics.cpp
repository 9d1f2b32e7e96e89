#include "tools/campuswalk/help/topics.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "engine/report/make_reporter.h"
#include "tools/campuswalk/base/schemas.h"
#include "tools/campuswalk/help/event_table.h"

namespace campuswalk::tools::help {

namespace {

constexpr std::size_t kWidth = 100;

/// A part of a schema, and its file, which its references are relative to.
struct SchemaPart {
    std::string file;
    Json schema;
};

Json file_of(std::string_view name) {
    const auto schemas = embedded_schemas();
    const auto found = std::ranges::find(schemas, name, &EmbeddedSchema::name);
    if (found == schemas.end()) {
        throw std::logic_error("no schema is called " + std::string(name));
    }
    return Json::parse(found->text);
}

SchemaPart part_at(std::string_view reference, const std::string& from) {
    const std::size_t hash = std::min(reference.find('#'), reference.size());
    const std::string file = hash == 0 ? from : std::string(reference.substr(0, hash));
    const std::string pointer(reference.substr(std::min(hash + 1, reference.size())));
    return {file, file_of(file).at(Json::json_pointer(pointer))};
}

/// Follows the part if it is a reference; a description beside that takes precedence.
SchemaPart resolved(SchemaPart part) {
    while (part.schema.contains("$ref")) {
        SchemaPart target = part_at(part.schema["$ref"].get<std::string>(), part.file);
        if (part.schema.contains("description")) {
            target.schema["description"] = part.schema["description"];
        }
        part = std::move(target);
    }
    return part;
}

/// The keys of a value that may be a map.
std::vector<std::string> keys_of(const SchemaPart& part) {
    std::vector<std::string> keys;
    const Json properties = part.schema.value("properties", Json::object());
    for (const auto& [key, unused] : properties.items()) {
        keys.push_back(key);
    }
    for (const char* list : {"anyOf", "oneOf"}) {
        if (!keys.empty() || !part.schema.contains(list)) {
            continue;
        }
        for (const Json& alternative : part.schema[list]) {
            for (const std::string& key : keys_of(resolved({part.file, alternative}))) {
                if (std::ranges::find(keys, key) == keys.end()) {
                    keys.push_back(key);
                }
            }
        }
    }
    return keys;
}

/// The schema of a list's entries or of the values of a map with free keys; any other part itself.
SchemaPart element_schema(const SchemaPart& part) {
    for (const char* key : {"items", "additionalProperties"}) {
        if (part.schema.contains(key) && part.schema[key].is_object()) {
            return resolved({part.file, part.schema[key]});
        }
    }
    return part;
}

std::string description_of(const SchemaPart& part) {
    std::string text = part.schema.value("description", "");
    if (part.schema.contains("default")) {
        const Json& value = part.schema["default"];
        text += " Default: " + (value.is_string() ? value.get<std::string>() : value.dump()) + ".";
    }
    const SchemaPart map = element_schema(part);
    std::string keys;
    for (const std::string& key :
         map.schema.contains("maxProperties") ? std::vector<std::string>() : keys_of(map)) {
        keys += (keys.empty() ? " Keys: " : ", ") + key;
    }
    return text + keys + (keys.empty() ? "" : ".");
}

/// The text in lines of at most kWidth columns. The first one starts at `column`, the others at `indent`.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent) {
    std::istringstream words{std::string(text)};
    std::string result;
    for (std::string word; words >> word;) {
        if (column + 1 + word.size() > kWidth && column > indent) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!result.empty()) {
            result += " ";
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result;
}

/// The keys of a map with their meanings, one paragraph per key, from a JSON Schema. `location` is the
/// schema's file and, after '#', the map in it: "walk.schema.json#/definitions/step".
std::string key_table(std::string_view location) {
    const SchemaPart map = resolved(part_at(location, ""));
    std::size_t widest = 0;
    for (const auto& [key, unused] : map.schema.at("properties").items()) {
        widest = std::max(widest, key.size());
    }
    std::string text;
    const std::size_t indent = widest + 4;
    for (const auto& [key, value] : map.schema.at("properties").items()) {
        text += "  " + key + std::string(indent - 2 - key.size(), ' ') +
                wrapped(description_of(resolved({map.file, value})), indent, indent) + "\n";
    }
    return text;
}

std::string walks() {
    return "NAME.walk.yaml describes a walk and what is expected of it. Its keys:\n\n" +
           key_table("walk.schema.json") + R"(
  # yaml-language-server: $schema=schema/walk.schema.json
  campus: school.campus.yaml
  avatar: adult
  steps:
    - spawn: gate
    - walk_to: desk
  expect:
    - sequence: [trigger.enter library/door, popup.open library]
    - reaches: desk

Lengths are in metres, angles in degrees, times in simulated seconds; +Y is up; yaw 0 looks along -Z,
positive yaw turns left. See: campuswalk help steps, help expectations, help events.
)";
}

std::string steps() {
    return "Each entry of 'steps' is a map with a single key; the first is 'spawn'.\n\n" +
           key_table("walk.schema.json#/definitions/step") + R"(
A target with a height counts as reached within 0.5 m of that height. 'run', 'speed', 'crouch', 'enable',
'disable', 'expect' and 'snapshot' take no time. Put steps shared by several walks into a NAME.steps.yaml,
whose only key is 'steps'.
)";
}

std::string expectations() {
    return R"(Each entry of 'expect' is a map with a single key. All of them are evaluated when the walk has ended; one
that doesn't hold makes the exit code 1.

)" + key_table("walk.schema.json#/definitions/single_expectation") +
           R"(
Four of them need no value: '- grounded', '- no_penetration', '- stuck', '- fell'; nor do they under 'not':
'- not: fell'. The step 'expect' evaluates the walk so far and ends it with a failure if one doesn't hold.

  status: xfail                                      the walk must fail
  status: {is: xfail, because: TEXT, failures: [blocked]}    with exactly these failures

Events are written KIND OBJECT, globs in both; without an object, any object matches: see campuswalk help
events. An event that can't occur on the campus is an error (exit code 2), so that a typo in a 'never' is
reported instead of passing.
)";
}

std::string events() {
    return R"(Each line of the log is an event: tick, seconds, kind, object, details. The kinds, with what their object is:

)" + event_lines() +
           R"(
A walk_to, go_to or follow without a name of its target has the coordinates. --json lists the details, too.

Patterns may contain globs: 'collision.* bench/*', 'popup.open library', 'avatar.fell'.
)";
}

std::string campus() {
    return "NAME.campus.yaml describes a campus. Its keys:\n\n" + key_table("campus.schema.json") +
           "\nAn origin's keys:\n\n" + key_table("campus.schema.json#/definitions/origin") +
           "\nThe keys of a file of places (from: FILE, {file: FILE, …} or a list of such):\n\n" +
           key_table("campus.schema.json#/definitions/place_file/anyOf/1") +
           "\nA collider's keys, by its shape:\n\nmesh:\n" +
           key_table("campus.schema.json#/definitions/mesh") + "\nbox, too:\n" + R"(  center, size, yaw_deg
sphere, too:
  center, radius
capsule, too:
  base, radius, height
wheel, too:
  center, radius, width, axis

'campuswalk info MODEL' lists a model's nodes; 'campuswalk snapshot CAMPUS -o map.png' draws a plan.
)";
}

std::string avatars() {
    return R"(NAME.avatar.yaml describes who walks. Profiles are looked up in 'avatars' and 'config/avatars' next to the
walk and above it, then among those that come with the program (adult, child, delivery-robot).

)" + key_table("avatar.schema.json") +
           "\nIn a walk: 'avatar: adult', or 'avatar: {profile: adult, speed: 1.8}'.\n";
}

std::string exit_codes() {
    return R"(0    every walk passed; of 'collide': apart; of 'validate': no errors
1    an expectation failed, or the visitor was blocked, fell, timed out or had no way to go; of
     'merge-reports': a walk failed, or results are missing; of 'diff', 'imgdiff' and 'replay --verify':
     different; of 'collide': overlapping; of 'route': no way; of 'explore': what --require, --fail-on or
     --fail-under forbids
2    bad usage or input, reported as FILE:LINE:COLUMN: error CODE: MESSAGE before that walk runs; of
     'report': results are missing
3    something failed while running: disk full, no OpenGL; without a message if the output has no reader
     any more, as after '| head'
5    nothing was selected
130  interrupted
)";
}

std::string lights() {
    return R"(NAME.light.yaml describes how pictures are lit. Profiles are looked up in 'lights' and 'config/lights' next
to the walk and above it, then among those that come with the program: day, overcast, night. Keys left out
keep their daytime values.

)" + key_table("light.schema.json") +
           "\nIn a walk: 'light: night', or 'light: {profile: night, anti_aliasing: fxaa}'.\n";
}

std::string projects() {
    return R"(walks.config.yaml holds the settings of 'campuswalk run' for the walks in its folder and below; options
on the command line take precedence.

)" + key_table("walks-config.schema.json") +
           R"(
  projects:
    as-written: {}
    robot: {avatar: robot, tags: [ramps]}

runs every walk as it is written, and those with the tag 'ramps' by a robot as well; '--project robot' selects
one.
)";
}

std::string popups() {
    return R"(A building's pop-up opens when the visitor first touches, enters or looks at one of its colliders, and
closes when the last such contact ends; colliders with 'popup: false' don't count. Keys of a building:

)" + key_table("campus.schema.json#/definitions/building") +
           "\n'popup' may be a map, for all colliders of a building or for one of them:\n\n" +
           key_table("campus.schema.json#/definitions/popup/anyOf/1") + R"(
Titles and texts may contain variables:

  {id} {kind} {hours} {floors}   the building's keys
  {title}                        in the text: the title as shown
  {visits}                       how often the pop-up has opened, including this time
  {time}                         when, in simulated time: mm:ss
  {NAME}                         a field of 'info'
  {{ }}                          braces

  buildings:
    - {id: kiosk, title: "Kiosk of {owner}", text: "{title}, visit {visits} at {time}.", info: {owner: Ada}}

An unknown variable is an error, reported with its line and column. To expect a pop-up in a walk:

  expect:
    - popup: kiosk                                      it opens
    - popup: {building: kiosk, body: "*visit 2 at *"}   with this text (a glob)
    - sequence: [popup.open kiosk, popup.close kiosk]
)";
}

std::string reports() {
    std::string kinds;
    for (const engine::ReporterKind& kind : engine::reporter_kinds()) {
        std::string name(kind.name);
        name.resize(10, ' ');
        kinds += "  " + name + std::string(kind.summary) + "\n";
    }
    return R"('campuswalk run --reporter NAME' or '--reporter NAME=FILE', repeatable; at most one without a file.

)" + kinds +
           R"(  log       the events, one per line; what a single walk prints without --reporter

Reports don't depend on the number of workers, and contain no wall-clock time and no absolute path.

  campuswalk run --shard=1/2 --reporter jsonl=1.jsonl      on one machine
  campuswalk run --shard=2/2 --reporter jsonl=2.jsonl      on another
  campuswalk merge-reports 1.jsonl 2.jsonl --reporter junit=junit.xml

gives what a single run would have reported, and exit code 1 if a shard's report is missing, incomplete,
there twice or of another run. 'campuswalk replay 1.jsonl --verify' repeats the walks of a
report, with the same projects and timeouts, and compares hashes.

  campuswalk run --reporter html=report.html                opens in a browser, from disk, offline
  campuswalk run --record report --reporter jsonl=1.jsonl   leaves what it takes in DIR of '--output DIR'
  campuswalk report 1.jsonl -o report.html --output DIR     makes it of that, also elsewhere

Pictures go to DIR of '--output DIR' (out): WALK/SNAPSHOT.png, and for a failure WALK/failure-eyes.png,
failure-beside.png (what is in the way, ringed) and failure-above.png.
'expect: [log: {golden: true}]' compares a walk's log with its golden log,
NAME.walk.yaml-snapshots/log.jsonl. 'run -u' writes it, except for a walk that fails for another reason, and
is refused where CI is set; without a golden log the walk fails.
)";
}

constexpr std::array kTopics = {
    Topic{"walks", "NAME.walk.yaml: a walk", walks},
    Topic{"steps", "What the visitor can do", steps},
    Topic{"expectations", "What can be expected of a walk", expectations},
    Topic{"events", "The events of the log, and how expectations name them", events, event_json},
    Topic{"campus", "NAME.campus.yaml: a campus", campus},
    Topic{"popups", "Information windows: when they open and what they show", popups},
    Topic{"avatars", "Who walks: NAME.avatar.yaml", avatars},
    Topic{"lights", "Sun, sky and fog in pictures: NAME.light.yaml", lights},
    Topic{"projects", "walks.config.yaml: one walk for several avatars, campuses or spawns", projects},
    Topic{"reports", "Reports of a run, and how runs are merged and compared", reports},
    Topic{"exit-codes", "Exit codes of the program", exit_codes},
};

}  // namespace

std::span<const Topic> topics() {
    return kTopics;
}

}  // namespace campuswalk::tools::help
