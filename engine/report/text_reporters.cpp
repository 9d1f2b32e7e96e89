#include <algorithm>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

enum class Color { none, green, red, yellow };

/// How a case's outcome is shown.
struct Mark {
    const char* word;
    char letter;
    Color color;
};

Mark mark_of(const WalkResult& result) {
    switch (result.outcome) {
        case Outcome::passed:
            return result.expected_to_fail ? Mark{"xfail", 'x', Color::green}
                                           : Mark{"pass", '.', Color::green};
        case Outcome::failed:
            return {"FAIL", 'F', Color::red};
        case Outcome::skipped:
            return {"skip", 's', Color::yellow};
        case Outcome::interrupted:
            return {"STOP", 'I', Color::yellow};
        default:
            return {"ERROR", 'E', Color::red};
    }
}

bool is_ok(const WalkResult& result) {
    return result.outcome == Outcome::passed || result.outcome == Outcome::skipped;
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

/// What both of them print: problems in full at the end, and the counts.
class TextReporter : public Reporter {
public:
    TextReporter(TextSink sink, ReportStyle style) : sink_(std::move(sink)), style_(std::move(style)) {}

    void result(const WalkResult& result) final {
        tally_.add(result);
        if (!style_.quiet) {
            print(result);
        }
    }

    void end(const ResultSequence& results) final {
        finish_cases();
        std::size_t problems = 0;
        results.for_each([&](const WalkResult& result) {
            if (!is_ok(result)) {
                print_problem(result, ++problems);
            }
        });
        if (!style_.quiet || problems > 0) {
            print_line("");
        }
        print_line(summary_of(tally_), problems == 0 ? Color::green : Color::red);
    }

protected:
    virtual void print(const WalkResult& result) = 0;
    virtual void finish_cases() {}

    /// Makes any words harmless.
    void print_line(std::string_view words, Color color = Color::none) {
        write(words, color);
        sink_("\n");
    }
    void write(std::string_view words, Color color = Color::none) {
        sink_(colored(scene::printable(words), color));
    }

private:
    std::string colored(const std::string& text, Color color) const {
        if (!style_.color || color == Color::none) {
            return text;
        }
        const char* code = color == Color::green ? "32" : color == Color::red ? "31" : "33";
        return std::string("\x1b[") + code + "m" + text + "\x1b[0m";
    }

    void print_problem(const WalkResult& result, std::size_t number) {
        print_line("");
        print_line(std::to_string(number) + ") " + result.id, Color::red);
        if (const std::string words = verdict_in_words(result); !words.empty()) {
            const std::string& reason = result.status_reason;
            print_line("   " + words + (reason.empty() ? "" : " (" + reason + ")"));
        }
        for (const scene::Diagnostic& diagnostic : result.diagnostics) {
            print_line("   " + to_string(diagnostic));
        }
        const FailureScene* before = nullptr;
        for (const Failure& failure : result.failures) {
            print_line("   " + headline_of(failure));
            if (before != nullptr && is_same(*before, failure.scene)) {
                print_line("     at the same moment");
            } else {
                print_scene(failure.scene);
            }
            before = &failure.scene;
        }
        for (const Artifact& artifact : result.artifacts) {
            const std::string folder = style_.folder.empty() ? "" : style_.folder + "/";
            print_line("   " + artifact.name + ": " + folder + artifact.path);
        }
    }

    static bool is_same(const FailureScene& a, const FailureScene& b) {
        return place_of(a) == place_of(b) && !place_of(a).empty() && a.last_events == b.last_events;
    }

    void print_scene(const FailureScene& scene) {
        if (const std::string place = place_of(scene); !place.empty()) {
            print_line("     " + place);
        }
        if (!scene.last_events.empty()) {
            print_line("     the last events before it:");
        }
        for (const std::string& event : scene.last_events) {
            print_line("       " + event);
        }
    }

    TextSink sink_;
    ReportStyle style_;
    Tally tally_;
};

class ListReporter final : public TextReporter {
public:
    using TextReporter::TextReporter;

private:
    void print(const WalkResult& result) override {
        // Most names fit; a longer one shifts the rest of its line to the right.
        constexpr std::size_t kWordWidth = 6;
        constexpr std::size_t kTitleWidth = 48;
        const Mark mark = mark_of(result);
        std::string line = result.id;
        std::string details = details_of(result);
        if (result.not_evaluated > 0) {
            details += "  " + not_evaluated_in_words(result.not_evaluated);
        }
        if (!details.empty()) {
            const std::size_t width = scene::printable(result.id).size();
            line += std::string(kTitleWidth - std::min(kTitleWidth, width), ' ') + "  " + details;
        }
        write(padded(mark.word, kWordWidth), mark.color);
        print_line(line);
    }

    static std::string details_of(const WalkResult& result) {
        const std::string& reason = result.status_reason;
        switch (result.outcome) {
            case Outcome::passed:
            case Outcome::failed:
                return fixed(seconds_of(result), 1) + " s  " + fixed(result.distance, 1) + " m" +
                       (reason.empty() ? "" : "  " + reason);
            default:
                return reason;
        }
    }
};

class DotReporter final : public TextReporter {
public:
    using TextReporter::TextReporter;

private:
    static constexpr int kDotsPerLine = 80;

    void print(const WalkResult& result) override {
        const Mark mark = mark_of(result);
        write(std::string(1, mark.letter), mark.color);
        if (++dots_ == kDotsPerLine) {
            finish_cases();
        }
    }

    void finish_cases() override {
        if (dots_ > 0) {
            print_line("");
        }
        dots_ = 0;
    }

    int dots_ = 0;
};

}  // namespace

std::unique_ptr<Reporter> make_list_reporter(TextSink sink, const ReportStyle& style) {
    return std::make_unique<ListReporter>(std::move(sink), style);
}

std::unique_ptr<Reporter> make_dot_reporter(TextSink sink, const ReportStyle& style) {
    return std::make_unique<DotReporter>(std::move(sink), style);
}

}  // namespace campuswalk::engine
