#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/report/reporters.h"
#include "engine/report/result_text.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

/// An unescaped `#` would begin a directive.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : scene::printable(text)) {
        if (c == '#' || c == '\\') {
            out += '\\';
        }
        out += c;
    }
    return out;
}

/// JSON strings are also YAML.
std::string quoted(const std::string& text) {
    return scene::printable_json(
        nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

class TapReporter final : public Reporter {
public:
    explicit TapReporter(TextSink sink) : sink_(std::move(sink)) {}

    void begin(const RunPlan& plan) override {
        write("TAP version 14");
        write("1.." + std::to_string(plan.cases));
    }

    void result(const WalkResult& result) override {
        const bool todo = failed_as_expected(result);
        const bool ok = (result.outcome == Outcome::passed && !todo) || result.outcome == Outcome::skipped;
        std::string line = (ok ? "ok " : "not ok ") + std::to_string(++number_) + " - " + escaped(result.id);
        if (todo || result.outcome == Outcome::skipped) {
            line += todo ? " # TODO"
                         : " # SKIP";  // TAP's directives: a failure that was expected, a test not run
            line += result.status_reason.empty() ? "" : " " + result.status_reason;
        }
        write(line);
        if (result.not_evaluated > 0) {
            write("# " + not_evaluated_in_words(result.not_evaluated));
        }
        if (!ok) {
            explain(result);
        }
    }

private:
    void explain(const WalkResult& result) {
        write("  ---");
        write("  outcome: " + std::string(name_of(result.outcome)));
        if (const std::string words = verdict_in_words(result); !words.empty()) {
            write("  message: " + quoted(words));
        }
        if (!result.diagnostics.empty()) {
            write("  complaints:");
        }
        for (const scene::Diagnostic& diagnostic : result.diagnostics) {
            write("    - " + quoted(to_string(diagnostic)));
        }
        if (!result.failures.empty()) {
            write("  failures:");
        }
        for (const Failure& failure : result.failures) {
            write("    - code: " + quoted(failure.code));
            write("      message: " + quoted(failure.message));
            write("      file: " + quoted(failure.mark.file));
            write("      line: " + std::to_string(failure.mark.line));
            write("      column: " + std::to_string(failure.mark.column));
            if (const std::string place = place_of(failure.scene); !place.empty()) {
                write("      place: " + quoted(place));
            }
        }
        write("  ...");
    }

    void write(const std::string& line) { sink_(scene::printable(line) + "\n"); }

    TextSink sink_;
    std::size_t number_ = 0;
};

}  // namespace

std::unique_ptr<Reporter> make_tap_reporter(TextSink sink, const ReportStyle& /*style*/) {
    return std::make_unique<TapReporter>(std::move(sink));
}

}  // namespace campuswalk::engine
