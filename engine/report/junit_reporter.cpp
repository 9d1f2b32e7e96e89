#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <pugixml.hpp>

#include "engine/events/decimals.h"
#include "engine/report/plain_text.h"
#include "engine/report/report_paths.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

class SinkWriter final : public pugi::xml_writer {
public:
    explicit SinkWriter(const TextSink& sink) : sink_(sink) {}
    void write(const void* data, std::size_t size) override { sink_({static_cast<const char*>(data), size}); }

private:
    const TextSink& sink_;
};

void set(pugi::xml_node node, const char* name, std::string_view value) {
    node.append_attribute(name).set_value(xml_characters(printable(value)).c_str());
}

void set_counts(pugi::xml_node node, std::size_t tests, const Tally& tally) {
    set(node, "tests", std::to_string(tests));
    set(node, "failures", std::to_string(tally.failed));
    set(node, "errors", std::to_string(tally.bad_input + tally.broken + tally.interrupted));
    set(node, "time", fixed(tally.seconds, 3));
}

void append_text(pugi::xml_node node, const char* name, const std::string& text) {
    if (!text.empty()) {
        node.append_child(name).append_child(pugi::node_pcdata).set_value(xml_characters(text).c_str());
    }
}

/// Everything about a failure, one fact per line.
std::string details_of(const Failure& failure) {
    std::string text = headline_of(failure) + "\n";
    if (const std::string place = place_of(failure.scene); !place.empty()) {
        text += place + "\n";
    }
    for (const std::string& event : failure.scene.last_events) {
        text += printable(event) + "\n";
    }
    return text;
}

void append_problem(pugi::xml_node test, const char* kind, std::string_view type, std::string_view message,
                    const std::string& details) {
    pugi::xml_node node = test.append_child(kind);
    set(node, "type", type);
    set(node, "message", message);
    node.append_child(pugi::node_pcdata).set_value(xml_characters(details).c_str());
}

/// Schemas allow several, but most readers show only the first: all failures are in it.
void append_failures(pugi::xml_node test, const WalkResult& result) {
    const std::string verdict = verdict_in_words(result);
    std::string details = verdict.empty() ? "" : verdict + "\n";
    for (const Failure& failure : result.failures) {
        details += details_of(failure);
    }
    const bool use_verdict = !verdict.empty() || result.failures.empty();
    append_problem(test, "failure", use_verdict ? "status" : result.failures.front().code,
                   use_verdict ? verdict : result.failures.front().message, details);
}

void append_error(pugi::xml_node test, const WalkResult& result) {
    std::string details;
    for (const std::string& diagnostic : result.diagnostics) {
        details += printable(diagnostic) + "\n";
    }
    const std::string verdict = verdict_in_words(result);
    append_problem(test, "error", name_of(result.outcome),
                   result.diagnostics.empty() ? verdict : result.diagnostics.front(), details + verdict);
}

/// Files that Jenkins and GitLab show beside a case: as seen from the repository's root, the folder of both
/// their jobs.
std::string attachments_of(const WalkResult& result, const std::string& folder) {
    std::string text;
    for (const Artifact& artifact : result.artifacts) {
        text += "[[ATTACHMENT|" + printable(path_in_repository(folder, artifact.path)) + "]]\n";
    }
    return text;
}

void append_case(pugi::xml_node suite, const WalkResult& result, const std::string& folder) {
    pugi::xml_node test = suite.append_child("testcase");
    std::string name = result.name;
    name += result.project.empty() ? "" : " " + result.project;
    name += result.repetition == 0 ? "" : " #" + std::to_string(result.repetition);
    set(test, "name", name);
    set(test, "classname", result.file);
    set(test, "time", fixed(seconds_of(result), 3));
    switch (result.outcome) {
        case Outcome::passed:
            break;
        case Outcome::failed:
            append_failures(test, result);
            break;
        case Outcome::skipped:
            set(test.append_child("skipped"), "message", result.status_reason);
            break;
        default:
            append_error(test, result);
    }
    append_text(test, "system-out", attachments_of(result, folder));
    std::string remarks =
        failed_as_expected(result) ? "failed as expected: " + printable(result.status_reason) : "";
    if (result.not_evaluated > 0) {
        remarks += (remarks.empty() ? "" : "\n") + not_evaluated_in_words(result.not_evaluated) +
                   ": nothing draws pictures";
    }
    append_text(test, "system-err", remarks);
}

class JunitReporter final : public Reporter {
public:
    JunitReporter(TextSink sink, std::string folder) : sink_(std::move(sink)), folder_(std::move(folder)) {}

    void result(const WalkResult&) override {}

    void end(const RunReport& report) override {
        pugi::xml_document document;
        pugi::xml_node declaration = document.append_child(pugi::node_declaration);
        set(declaration, "version", "1.0");
        set(declaration, "encoding", "UTF-8");
        pugi::xml_node root = document.append_child("testsuites");
        Tally all;
        for (const WalkResult& result : report.results) {
            all.add(result);
        }
        set(root, "name", "campuswalk");
        set_counts(root, report.results.size(), all);
        for (const auto& [file, results] : by_file(report)) {
            append_suite(root, file, results, folder_);
        }
        SinkWriter writer(sink_);
        document.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
    }

private:
    using Suites = std::vector<std::pair<std::string, std::vector<const WalkResult*>>>;

    /// In the order of their first cases.
    static Suites by_file(const RunReport& report) {
        Suites suites;
        std::map<std::string, std::size_t> places;
        for (const WalkResult& result : report.results) {
            const auto [place, is_new] = places.try_emplace(result.file, suites.size());
            if (is_new) {
                suites.push_back({result.file, {}});
            }
            suites[place->second].second.push_back(&result);
        }
        return suites;
    }

    static void append_suite(pugi::xml_node root, const std::string& file,
                             const std::vector<const WalkResult*>& results, const std::string& folder) {
        pugi::xml_node suite = root.append_child("testsuite");
        Tally tally;
        for (const WalkResult* result : results) {
            tally.add(*result);
        }
        set(suite, "name", file);
        set_counts(suite, results.size(), tally);
        set(suite, "skipped", std::to_string(tally.skipped));
        for (const WalkResult* result : results) {
            append_case(suite, *result, folder);
        }
    }

    TextSink sink_;
    std::string folder_;  ///< the run's output folder
};

}  // namespace

std::unique_ptr<Reporter> make_junit_reporter(TextSink sink, const ReportStyle& style) {
    return std::make_unique<JunitReporter>(std::move(sink), style.folder);
}

}  // namespace campuswalk::engine
