#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/report/plain_text.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

/// A `#` would begin a directive.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        if (c == '#' || c == '\\') {
            out += '\\';
        }
        out += c;
    }
    return out;
}

/// JSON's texts are YAML's too.
std::string quoted(const std::string& text) {
    return nlohmann::json(valid_utf8(text)).dump();
}

class TapReporter final : public Reporter {
public:
    explicit TapReporter(TextSink sink) : sink_(std::move(sink)) {}

    void begin(std::size_t cases) override {
        say("TAP version 14");
        say("1.." + std::to_string(cases));
    }

    void result(const WalkResult& result) override {
        const bool todo = failed_as_expected(result);
        const bool ok = (result.outcome == Outcome::passed && !todo) || result.outcome == Outcome::skipped;
        std::string line = (ok ? "ok " : "not ok ") + std::to_string(++number_) + " - " + escaped(result.id);
        if (todo || result.outcome == Outcome::skipped) {
            line += todo ? " # TODO" : " # SKIP";
            line += result.status_reason.empty() ? "" : " " + printable(result.status_reason);
        }
        say(line);
        if (!ok) {
            explain(result);
        }
    }

private:
    void explain(const WalkResult& result) {
        say("  ---");
        say("  outcome: " + std::string(name_of(result.outcome)));
        if (const std::string words = verdict_in_words(result); !words.empty()) {
            say("  message: " + quoted(words));
        }
        if (!result.diagnostics.empty()) {
            say("  complaints:");
        }
        for (const std::string& diagnostic : result.diagnostics) {
            say("    - " + quoted(diagnostic));
        }
        if (!result.failures.empty()) {
            say("  failures:");
        }
        for (const Failure& failure : result.failures) {
            say("    - code: " + quoted(failure.code));
            say("      message: " + quoted(failure.message));
            say("      file: " + quoted(failure.mark.file));
            say("      line: " + std::to_string(failure.mark.line));
            say("      column: " + std::to_string(failure.mark.column));
            if (const std::string place = place_of(failure.scene); !place.empty()) {
                say("      place: " + quoted(place));
            }
        }
        say("  ...");
    }

    void say(const std::string& line) { sink_(line + "\n"); }

    TextSink sink_;
    std::size_t number_ = 0;
};

}  // namespace

std::unique_ptr<Reporter> make_tap_reporter(TextSink sink) {
    return std::make_unique<TapReporter>(std::move(sink));
}

}  // namespace campuswalk::engine
