#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "engine/report/github_text.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

/// Removes `:NUMBER` from the end; 0 if there is none.
int take_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon + 1 == text.size()) {
        return 0;
    }
    int number = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data() + colon + 1, end, number).ptr != end) {
        return 0;
    }
    text = text.substr(0, colon);
    return number;
}

/// The parts of `file:line:col: error CODE: message`; any other text is a message as a whole.
Failure parts_of(std::string_view diagnostic) {
    constexpr std::string_view kError = ": error ";
    Failure parts;
    const std::size_t place = diagnostic.find(kError);
    const std::size_t code = place == std::string_view::npos ? place : place + kError.size();
    const std::size_t message = code == std::string_view::npos ? code : diagnostic.find(": ", code);
    if (message == std::string_view::npos) {
        parts.code = "error";
        parts.message = std::string(diagnostic);
        return parts;
    }
    std::string_view file = diagnostic.substr(0, place);
    const int last = take_number(file);
    const int first = take_number(file);
    parts.mark = {std::string(file), first > 0 ? first : last, first > 0 ? last : 0};
    parts.code = std::string(diagnostic.substr(code, message - code));
    parts.message = std::string(diagnostic.substr(message + 2));
    return parts;
}

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
        for (const std::string& diagnostic : result.diagnostics) {
            annotate(result, parts_of(diagnostic));
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
