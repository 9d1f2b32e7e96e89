#include <string>
#include <utility>

#include "engine/report/github_text.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

class GithubReporter final : public Reporter {
public:
    explicit GithubReporter(TextSink sink) : sink_(std::move(sink)) {}

    void result(const WalkResult& result) override {
        tally_.add(result);
        if (result.outcome == Outcome::passed || result.outcome == Outcome::skipped) {
            return;
        }
        if (const std::string words = verdict_in_words(result); !words.empty()) {
            Failure whole;
            whole.code = name_of(result.outcome);
            whole.message = words;
            annotate(result, whole);
        }
        for (const auto& [severity, mark, code, message] : result.diagnostics) {
            annotate(result, {mark, code.empty() ? "error" : std::string(code.text()), message, {}});
        }
        for (const Failure& failure : result.failures) {
            annotate(result, failure);
        }
    }

    void end(const ResultSequence&) override {
        sink_("::notice title=campuswalk::" + github_escaped(summary_of(tally_), false) + "\n");
    }

private:
    void annotate(const WalkResult& result, const Failure& failure) {
        const std::string& file = failure.mark.file.empty() ? result.file : failure.mark.file;
        std::string command = "::error file=" + github_escaped(file, true);
        if (failure.mark.line > 0) {
            command += ",line=" + std::to_string(failure.mark.line);
        }
        if (failure.mark.column > 0) {
            command += ",col=" + std::to_string(failure.mark.column);
        }
        command += ",title=" + github_escaped(result.id + ": " + failure.code, true);
        const std::string place = place_of(failure.scene);
        sink_(command + "::" + github_escaped(failure.message + (place.empty() ? "" : "\n" + place), false) +
              "\n");
    }

    TextSink sink_;
    Tally tally_;
};

}  // namespace

std::unique_ptr<Reporter> make_github_reporter(TextSink sink, const ReportStyle& /*style*/) {
    return std::make_unique<GithubReporter>(std::move(sink));
}

}  // namespace campuswalk::engine
