// YAML files, event patterns, reports and logs.

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/load_campus.h"
#include "config/loader/load_profile.h"
#include "config/loader/load_run.h"
#include "config/loader/walks_config.h"
#include "engine/report/result_json.h"
#include "scene/base/diagnostic.h"
#include "tests/config/config_folder.h"
#include "tests/fuzz/targets/targets.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/logs/log_lines.h"
#include "tools/campuswalk/logs/recorded_walks.h"

namespace campuswalk::fuzz {

namespace {

std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> lines_of(Bytes bytes) {
    const std::vector<std::string_view> lines = tools::split(as_text(bytes), '\n');
    return {lines.begin(), lines.end()};
}

/// What refuses bad input must say where it is, in words that can be printed.
void check(const scene::InputError& error) {
    for (const scene::Diagnostic& diagnostic : error.diagnostics()) {
        if (diagnostic.code.empty() || diagnostic.message.empty() || diagnostic.mark.file.empty()) {
            throw std::logic_error("a diagnostic says nothing: " + scene::to_string(diagnostic));
        }
    }
}

/// The file, beside others that are in order.
template <typename Load>
void load(const char* name, std::string_view text, const Load& load) {
    static const config::test::ConfigFolder folder;
    folder.write(name, text);
    try {
        load(folder.path(name));
    } catch (const scene::InputError& error) {
        check(error);
    }
}

void read_walk(Bytes bytes) {
    static config::RunLoader loader({});
    load("fuzzed.walk.yaml", as_text(bytes), [](const auto& file) { loader.load(file); });
}

void read_campus(Bytes bytes) {
    load("fuzzed.campus.yaml", as_text(bytes),
         [](const auto& file) { config::load_campus_description(file); });
}

/// A file of places, as longitudes and as metres.
void read_places(Bytes bytes) {
    static const config::test::ConfigFolder folder;
    folder.write("fuzzed.geojson", as_text(bytes));
    for (const char* keys : {"", ", coordinates: campus, name: a, height: 1, where: {b: [1, c]}"}) {
        folder.write("places.campus.yaml",
                     "scenes: [{file: a.obj}]\ncolliders: []\norigin: {latitude_deg: 48, longitude_deg: 11}\n"
                     "places: {from: {file: fuzzed.geojson" +
                         std::string(keys) + "}}\n");
        try {
            config::load_campus_description(folder.path("places.campus.yaml"));
        } catch (const scene::InputError& error) {
            check(error);
        }
    }
}

void read_profiles(Bytes bytes) {
    load("fuzzed.avatar.yaml", as_text(bytes), [](const auto& file) { config::load_avatar(file); });
    load("fuzzed.light.yaml", as_text(bytes), [](const auto& file) { config::load_light(file); });
}

void read_steps(Bytes bytes) {
    load("fuzzed.steps.yaml", as_text(bytes), [](const auto& file) { config::load_steps(file); });
}

void read_config(Bytes bytes) {
    load("walks.config.yaml", as_text(bytes), [](const auto& file) { config::load_walks_config(file); });
}

/// As the value of an expectation, in quotes.
void read_pattern(Bytes bytes) {
    std::string quoted;
    for (const char c : as_text(bytes)) {
        quoted += c == '\'' ? "''" : std::string(1, c);
    }
    const std::string walk = "campus: a.campus.yaml\nsteps: [{spawn: gate}]\nexpect: [{never: '" + quoted +
                             "'}, {sequence: ['" + quoted + "']}]\n";
    read_walk({reinterpret_cast<const std::uint8_t*>(walk.data()), walk.size()});
}

/// A report in JSON lines, as merge-reports, replay and --resume read it.
void read_report(Bytes bytes) {
    const std::vector<std::string> lines = lines_of(bytes);
    for (const std::string& line : lines) {
        try {
            engine::plan_from_header_line(line);
        } catch (const std::runtime_error&) {
        }
        try {
            const std::string once = to_json_line(engine::result_from_json_line(line));
            if (to_json_line(engine::result_from_json_line(once)) != once) {
                throw std::logic_error("a result changes when it is written and read");
            }
        } catch (const std::runtime_error&) {
        }
    }
    try {
        tools::recorded_walks("report.jsonl", lines, {});
    } catch (const scene::InputError& error) {
        check(error);
    }
}

/// Two logs, with an empty line between, compared as `diff` does; the first one also as a golden log.
void read_logs(Bytes bytes) {
    static const support::TemporaryFolder folder;
    const std::string_view text = as_text(bytes);
    const std::size_t between = text.find("\n\n");
    const std::string_view first = text.substr(0, between);
    const std::string_view second = between == text.npos ? "" : text.substr(between + 2);
    const auto lines = [](std::string_view log) {
        const std::vector<std::string_view> views = tools::split(log, '\n');
        return std::vector<std::string>(views.begin(), views.end());
    };
    const std::vector<std::string> a = lines(first);
    const std::vector<std::string> b = lines(second);
    tools::first_divergence(a, b);
    for (const std::string& line : a) {
        tools::as_text_line(line);
    }
    folder.write("a.walk.yaml-snapshots/log.jsonl", first);
    try {
        tools::check_golden(folder.path() / "a.walk.yaml", "", b, tools::UpdateSnapshots::none);
    } catch (const scene::InputError& error) {
        check(error);
    }
}

constexpr std::array kTargets = {
    Target{"walk", read_walk},     Target{"campus", read_campus}, Target{"profiles", read_profiles},
    Target{"steps", read_steps},   Target{"config", read_config}, Target{"pattern", read_pattern},
    Target{"report", read_report}, Target{"logs", read_logs},     Target{"places", read_places}};

}  // namespace

std::span<const Target> text_targets() {
    return kTargets;
}

}  // namespace campuswalk::fuzz
