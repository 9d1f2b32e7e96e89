#include "engine/report/make_reporter.h"

#include <algorithm>
#include <utility>

#include "engine/report/report_paths.h"
#include "engine/report/reporters.h"
#include "scene/base/texts_of.h"

namespace campuswalk::engine {

namespace {

/// Hands on what it gets with paths as seen from the repository's root.
class RepositoryReporter final : public Reporter {
public:
    RepositoryReporter(std::string start, std::unique_ptr<Reporter> reporter)
        : start_(std::move(start)), reporter_(std::move(reporter)) {}

    void begin(const RunPlan& plan) override {
        RunPlan placed = plan;
        placed.start = start_;
        reporter_->begin(placed);
    }
    void result(const WalkResult& result) override {
        reporter_->result(with_paths_in_repository(start_, result));
    }
    void end(const ResultSequence& results) override {
        reporter_->end(ResultSequence([&](const ResultSequence::Visit& visit) {
            results.for_each(
                [&](const WalkResult& result) { visit(with_paths_in_repository(start_, result)); });
        }));
    }

private:
    std::string start_;
    std::unique_ptr<Reporter> reporter_;
};

}  // namespace

std::span<const ReporterKind> reporter_kinds() {
    return kReporterKinds;
}

std::vector<std::string> reporter_names() {
    return scene::texts_of(kReporterKinds, &ReporterKind::name);
}

std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style) {
    const auto kind = std::ranges::find(kReporterKinds, name, &ReporterKind::name);
    std::unique_ptr<Reporter> reporter =
        kind == kReporterKinds.end() ? nullptr : kind->make(std::move(sink), style);
    // html reads files where the run was started, and places what it shows itself.
    if (!reporter || style.start.empty() || name == "html") {
        return reporter;
    }
    return std::make_unique<RepositoryReporter>(style.start, std::move(reporter));
}

std::unique_ptr<Reporter> make_html_reporter(TextSink sink, const ReportStyle& style) {
    return style.html ? style.html(std::move(sink)) : nullptr;
}

}  // namespace campuswalk::engine
