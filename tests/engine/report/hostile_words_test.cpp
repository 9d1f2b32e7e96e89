#include <regex>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/report/artifact_path.h"
#include "engine/report/result_fields.h"
#include "scene/base/printable.h"
#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

/// What may be a command or a marker wherever it is, or at the start of a line.
const std::vector<std::string> kHostile = {
    "::error::x",
    "  ::add-mask::x",
    "a\n::set-output name=b::c",
    "\u2028::x",
    "\u00a0::x",
    "##[command]x",
    "x##vso[task.setvariable variable=a]b",
    "###VSO[x]",
    "##teamcity[x]",
    "[[ATTACHMENT|/etc/passwd]]",
    "x [[[property|a=b]]",
    "\x1b[2J\x1b]0;owned\x07",
    "a\u202eb\u2066c\u200bd\u3164e\u2800f\ufe0fg\u00ad\U000E0041",
    "Bail out!",
    "ok 1 - x",
    "]]> --> <b> & \" ' %",
};

/// Puts words into every text of a result, also into those that somebody adds to list_fields().
class Filler {
public:
    explicit Filler(std::string words) : words_(std::move(words)) {}

    template <typename Value>
    void operator()(const char* /*name*/, Value&& value) {
        fill(value);
    }
    template <typename Value>
    void if_any(const char* /*name*/, Value& value) {
        fill(value);
    }

    std::size_t texts = 0;

private:
    void fill(std::string& text) {
        text = words_;
        ++texts;
    }
    void fill(scene::DiagnosticCode& code) { code = "bad-value"; }
    void fill(std::optional<Reason>& reason) {
        reason = Reason{.object = words_, .node = words_, .name = words_};
        reason->parts = {*reason};
        ++texts;
    }
    void fill(std::optional<RouteHint>& hint) {
        hint = RouteHint{words_};
        ++texts;
    }
    template <typename Item>
    void fill(std::vector<Item>& list) {
        list.resize(2);
        for (Item& item : list) {
            fill(item);
        }
    }
    template <typename Value>
    void fill(Value& value) {
        if constexpr (std::is_same_v<Value, Failure> || std::is_same_v<Value, FailureScene> ||
                      std::is_same_v<Value, Artifact>) {
            list_fields(*this, value);
        }
    }

    std::string words_;
};

RunReport report_full_of(const std::string& words) {
    RunReport report;
    for (const auto& [outcome, name] : kOutcomeNames) {
        for (const bool expected_to_fail : {false, true}) {
            WalkResult result = full_result();
            Filler filler(words);
            list_fields(filler, result);
            EXPECT_GT(filler.texts, 20U);
            result.outcome = outcome;
            result.expected_to_fail = expected_to_fail;
            result.not_evaluated = 1;
            report.results.push_back(result);
        }
    }
    return report;
}

/// The reporter's own command may begin a line; nothing else may be one.
void expect_harmless(std::string text, const std::string& reporter, const std::string& words) {
    static const std::regex marker(R"(##[A-Za-z]*\[|\[\[[A-Za-z]*\|)");
    if (reporter == "junit" && is_artifact_path(words)) {  // as the path of an artifact, too
        text = std::regex_replace(text, std::regex(R"(\[\[ATTACHMENT\|[^\[\]|]*\]\])"), "attached");
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_FALSE(std::regex_search(line, marker)) << reporter << ": " << line;
        const bool own = reporter == "github" && (line.starts_with("::error file=") ||
                                                  line.starts_with("::notice title=campuswalk::"));
        EXPECT_TRUE(own || !line.substr(std::min(line.find_first_not_of(' '), line.size())).starts_with("::"))
            << reporter << ": " << line;
        if (!own) {
            const bool markdown = reporter == "markdown";  // its symbols have a variation selector
            EXPECT_TRUE(markdown || scene::printable(line) == line) << reporter << ": " << line;
        }
    }
}

TEST(HostileWords, StayWordsInEveryReport) {
    const std::vector<ReportStyle> styles = {
        {}, {.folder = "out", .start = "tests"}, {.images_url = "https://x/"}};
    for (const std::string& words : kHostile) {
        const RunReport report = report_full_of(words);
        for (const std::string& reporter : reporters_of_results()) {
            for (const ReportStyle& style : styles) {
                const std::string text = written(reporter, report, style);
                EXPECT_GT(text.size(), 100U);
                expect_harmless(text, reporter, words);
            }
        }
    }
}

TEST(HostileWords, LeaveMarkdownItsOwnHeadings) {
    const std::string text = written("markdown", report_full_of("## x"));
    EXPECT_TRUE(text.starts_with("## campuswalk: ")) << text;
    EXPECT_NE(text.find("\n### \\#\\# x\n"), std::string::npos) << text;
}

TEST(HostileWords, LeaveTheAttachmentsThatAreMeant) {
    RunReport report{{failed_result("visit")}};
    EXPECT_NE(
        written("junit", report, {.folder = "out"}).find("[[ATTACHMENT|out/visit/failure-above.png]]\n"),
        std::string::npos);
    const std::string text = written("junit", report, {.folder = "o]]u"});
    EXPECT_EQ(text.find("[[ATTACHMENT|"), std::string::npos) << "the marker has no escape";
    EXPECT_NE(text.find("failure from above: o]]u/visit/failure-above.png"), std::string::npos) << text;
}

}  // namespace
}  // namespace campuswalk::engine
