#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/report/artifact_path.h"
#include "engine/report/report_paths.h"
#include "engine/report/reporters.h"
#include "engine/report/result_text.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

// GitHub takes a megabyte for a step's summary, and nobody reads that much.
constexpr std::size_t kMostRows = 500;
constexpr std::size_t kMostDetails = 30;

/// Text that Markdown shows as it is. What makes a link of an address (`https:`, `www.`) or a name is
/// escaped, too: names come from strangers' files.
std::string markdown_text(std::string_view text) {
    constexpr std::string_view kMarkup = "\\`*_{}[]()<>#+!|~@:&$";
    std::string escaped;
    for (const char c : scene::printable(text)) {
        const bool ends_www = c == '.' && (escaped.ends_with("www") || escaped.ends_with("WWW"));
        if (ends_www || kMarkup.find(c) != std::string_view::npos) {
            escaped += '\\';
        }
        escaped += c;
    }
    return escaped;
}

/// As part of an address, between `<` and `>`.
std::string in_address(std::string_view path) {
    constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    std::string address;
    for (const char& c : path) {
        address += kPlain.find(c) != std::string_view::npos ? std::string{c} : percent_encoded({&c, 1});
    }
    return address;
}

const char* symbol_of(const WalkResult& result) {
    switch (result.outcome) {
        case Outcome::passed:
            return result.expected_to_fail ? "✅ xfail" : "✅";
        case Outcome::skipped:
            return "⏭️ skipped";
        case Outcome::failed:
            return "❌";
        case Outcome::interrupted:
            return "⏹️ interrupted";
        default:
            return "💥 error";
    }
}

/// What the table says of a walk: why it isn't simply passed.
std::string remark_of(const WalkResult& result) {
    if (!result.failures.empty() && result.outcome == Outcome::failed) {
        return result.failures.front().message;
    }
    if (!result.diagnostics.empty()) {
        return to_string(result.diagnostics.front());
    }
    const std::string verdict = verdict_in_words(result);
    return verdict.empty() ? result.status_reason : verdict;
}

bool is_problem(const WalkResult& result) {
    return result.outcome != Outcome::passed && result.outcome != Outcome::skipped;
}

class MarkdownReporter final : public Reporter {
public:
    MarkdownReporter(TextSink sink, const ReportStyle& style)
        : sink_(std::move(sink)), folder_(style.folder), images_url_(style.images_url) {}

    /// Keeps what the table may show.
    void result(const WalkResult& result) override {
        tally_.add(result);
        ++cases_;
        std::vector<WalkResult>& shown = is_problem(result) ? problems_ : good_;
        if (shown.size() < kMostRows) {
            shown.push_back(result);
        }
    }

    void end(const ResultSequence& /*results*/) override {
        write("## campuswalk: " + markdown_text(summary_of(tally_)) + "\n");
        write_table();
        for (std::size_t i = 0; i < std::min(problems_.size(), kMostDetails); ++i) {
            write_details(problems_[i]);
        }
        if (problems_.size() > kMostDetails) {
            write("… and more, which the other reports have.\n");
        }
    }

private:
    void write(const std::string& line) { sink_(line + "\n"); }

    /// Problems first, as the table may be cut.
    void write_table() {
        if (cases_ == 0) {
            return;
        }
        write("| | walk | time | distance | |");
        write("|---|---|--:|--:|---|");
        for (const WalkResult& result : problems_) {
            write_row(result);
        }
        for (std::size_t i = 0; i < std::min(good_.size(), kMostRows - problems_.size()); ++i) {
            write_row(good_[i]);
        }
        if (cases_ > kMostRows) {
            write("\n… and " + std::to_string(cases_ - kMostRows) + " more.");
        }
        write("");
    }

    void write_row(const WalkResult& result) {
        write(std::string("| ") + symbol_of(result) + " | " + markdown_text(result.id) + " | " +
              fixed(seconds_of(result), 1) + " s | " + fixed(result.distance, 1) + " m | " +
              markdown_text(remark_of(result)) + " |");
    }

    void write_details(const WalkResult& result) {
        write("### " + markdown_text(result.id) + "\n");
        for (const scene::Diagnostic& diagnostic : result.diagnostics) {
            write("- " + markdown_text(to_string(diagnostic)));
        }
        if (const std::string verdict = verdict_in_words(result); !verdict.empty()) {
            write("- " + markdown_text(verdict));
        }
        for (const Failure& failure : result.failures) {
            write("- " + markdown_text(headline_of(failure)));
            if (const std::string place = place_of(failure.scene); !place.empty()) {
                write("  " + markdown_text(place));
            }
        }
        write("");
        for (const Artifact& artifact : result.artifacts) {
            if (artifact.media_type.starts_with("image/")) {
                write_image(artifact);
            }
        }
    }

    /// Without an address where it can be seen, its place among the job's artifacts.
    void write_image(const Artifact& artifact) {
        const std::string path = published_path(folder_, artifact.path);
        if (images_url_.empty()) {
            write("- " + markdown_text(artifact.name) + ": " + markdown_text(path));
        } else {
            write("![" + markdown_text(artifact.name) + "](<" + images_url_ + in_address(path) + ">)\n");
        }
    }

    TextSink sink_;
    std::string folder_;
    std::string images_url_;
    Tally tally_;
    std::size_t cases_ = 0;
    std::vector<WalkResult> problems_;  ///< the first of them
    std::vector<WalkResult> good_;      ///< likewise
};

}  // namespace

std::unique_ptr<Reporter> make_markdown_reporter(TextSink sink, const ReportStyle& style) {
    return std::make_unique<MarkdownReporter>(std::move(sink), style);
}

}  // namespace campuswalk::engine
