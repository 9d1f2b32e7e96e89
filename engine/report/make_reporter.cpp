#include "engine/report/make_reporter.h"

#include <algorithm>
#include <utility>

#include "engine/report/reporters.h"

namespace campuswalk::engine {

std::span<const ReporterKind> reporter_kinds() {
    return kReporterKinds;
}

std::vector<std::string> reporter_names() {
    std::vector<std::string> names;
    for (const ReporterKind& kind : kReporterKinds) {
        names.emplace_back(kind.name);
    }
    return names;
}

std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style) {
    const auto kind = std::ranges::find(kReporterKinds, name, &ReporterKind::name);
    return kind == kReporterKinds.end() ? nullptr : kind->make(std::move(sink), style);
}

std::unique_ptr<Reporter> make_html_reporter(TextSink sink, const ReportStyle& style) {
    return style.html ? style.html(std::move(sink)) : nullptr;
}

}  // namespace campuswalk::engine
