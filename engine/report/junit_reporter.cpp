#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <pugixml.hpp>

#include "engine/events/decimals.h"
#include "engine/report/report_paths.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

using Lines = std::vector<std::string>;

class SinkWriter final : public pugi::xml_writer {
public:
    explicit SinkWriter(const TextSink& sink) : sink_(sink) {}
    void write(const void* data, std::size_t size) override { sink_({static_cast<const char*>(data), size}); }

private:
    const TextSink& sink_;
};

/// Words of an attribute.
void set(pugi::xml_node node, const char* name, std::string_view value) {
    node.append_attribute(name).set_value(scene::printable(value).c_str());
}

void set_counts(pugi::xml_node node, std::size_t tests, const Tally& tally) {
    set(node, "tests", std::to_string(tests));
    set(node, "failures", std::to_string(tally.failed));
    set(node, "errors", std::to_string(tally.bad_input + tally.broken + tally.interrupted));
    set(node, "time", fixed(tally.seconds, 3));
}

void append_lines(pugi::xml_node node, const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += scene::printable(line) + "\n";
    }
    node.append_child(pugi::node_pcdata).set_value(text.c_str());
}

/// Everything about a failure, one fact per line.
void add_details(const Failure& failure, Lines& lines) {
    lines.push_back(headline_of(failure));
    if (const std::string place = place_of(failure.scene); !place.empty()) {
        lines.push_back(place);
    }
    lines.insert(lines.end(), failure.scene.last_events.begin(), failure.scene.last_events.end());
}

void append_problem(pugi::xml_node test, const char* kind, std::string_view type, std::string_view message,
                    const Lines& details) {
    pugi::xml_node node = test.append_child(kind);
    set(node, "type", type);
    set(node, "message", message);
    append_lines(node, details);
}

/// Schemas allow several, but most readers show only the first: all failures are in it.
void append_failures(pugi::xml_node test, const WalkResult& result) {
    Lines details;
    for (const Failure& failure : result.failures) {
        add_details(failure, details);
    }
    const bool says_why = !result.failures.empty();
    append_problem(test, "failure", says_why ? result.failures.front().code : name_of(result.outcome),
                   says_why ? result.failures.front().message : "", details);
}

void append_error(pugi::xml_node test, const WalkResult& result) {
    Lines details;
    for (const scene::Diagnostic& diagnostic : result.diagnostics) {
        details.push_back(to_string(diagnostic));
    }
    const std::string verdict = verdict_in_words(result);
    if (!verdict.empty()) {
        details.push_back(verdict);
    }
    append_problem(test, "error", name_of(result.outcome), details.empty() ? "" : details.front(), details);
}

/// Files that Jenkins and GitLab show beside a case: as seen from the repository's root, the folder of both
/// their jobs. Their marker has no escape: of a path that would break it, only the words are there.
void append_attachments(pugi::xml_node test, const WalkResult& result, const std::string& folder) {
    std::string text;
    for (const Artifact& artifact : result.artifacts) {
        const std::string path = published_path(folder, artifact.path);
        const bool fits = path.find_first_of("[]|") == std::string::npos && scene::printable(path) == path;
        text += fits ? "[[ATTACHMENT|" + path + "]]\n" : scene::printable(artifact.name + ": " + path) + "\n";
    }
    if (!text.empty()) {
        test.append_child("system-out").append_child(pugi::node_pcdata).set_value(text.c_str());
    }
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
    append_attachments(test, result, folder);
    Lines remarks;
    if (failed_as_expected(result)) {
        remarks.push_back("failed as expected: " + result.status_reason);
    }
    if (result.not_evaluated > 0) {
        remarks.push_back(not_evaluated_in_words(result.not_evaluated) + ": nothing draws pictures");
    }
    if (!remarks.empty()) {
        append_lines(test.append_child("system-err"), remarks);
    }
}

class JunitReporter final : public Reporter {
public:
    JunitReporter(TextSink sink, std::string folder) : sink_(std::move(sink)), folder_(std::move(folder)) {}

    void result(const WalkResult& result) override {
        ++cases_;
        tally_.add(result);
    }

    /// A suite at a time, which fits into memory where the run doesn't: the cases of a file follow each
    /// other.
    void end(const ResultSequence& results) override {
        sink_("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + opening_of_root());
        std::vector<WalkResult> suite;
        results.for_each([&](const WalkResult& result) {
            if (!suite.empty() && suite.front().file != result.file) {
                write_suite(suite);
                suite.clear();
            }
            suite.push_back(result);
        });
        if (!suite.empty()) {
            write_suite(suite);
        }
        if (cases_ > 0) {
            sink_("</testsuites>\n");
        }
    }

private:
    /// Of an element with children if there are cases.
    std::string opening_of_root() const {
        pugi::xml_document document;
        pugi::xml_node root = document.append_child("testsuites");
        set(root, "name", "campuswalk");
        set_counts(root, cases_, tally_);
        std::string text;
        const TextSink append = [&](std::string_view part) { text += part; };
        SinkWriter writer(append);
        root.print(writer, "  ", pugi::format_default, pugi::encoding_utf8);
        if (const std::string_view closed = " />\n"; cases_ > 0 && text.ends_with(closed)) {
            text.replace(text.size() - closed.size(), closed.size(), ">\n");
        }
        return text;
    }

    void write_suite(const std::vector<WalkResult>& results) {
        pugi::xml_document document;
        pugi::xml_node suite = document.append_child("testsuite");
        Tally tally;
        for (const WalkResult& result : results) {
            tally.add(result);
        }
        set(suite, "name", results.front().file);
        set_counts(suite, results.size(), tally);
        set(suite, "skipped", std::to_string(tally.skipped));
        for (const WalkResult& result : results) {
            append_case(suite, result, folder_);
        }
        SinkWriter writer(sink_);
        suite.print(writer, "  ", pugi::format_default, pugi::encoding_utf8, 1);
    }

private:
    TextSink sink_;
    std::string folder_;  ///< the run's output folder
    std::size_t cases_ = 0;
    Tally tally_;
};

}  // namespace

std::unique_ptr<Reporter> make_junit_reporter(TextSink sink, const ReportStyle& style) {
    return std::make_unique<JunitReporter>(std::move(sink), style.folder);
}

}  // namespace campuswalk::engine
