#include "engine/report/make_reporter.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/report/reporters.h"

namespace campuswalk::engine {

namespace {

struct ReporterKind {
    std::string_view name;
    std::unique_ptr<Reporter> (*make)(TextSink sink, const ReportStyle& style);
};

template <std::unique_ptr<Reporter> (*make)(TextSink)>
std::unique_ptr<Reporter> without_style(TextSink sink, const ReportStyle&) {
    return make(std::move(sink));
}

constexpr std::array kKinds = {ReporterKind{"list", make_list_reporter},
                               ReporterKind{"dot", make_dot_reporter},
                               ReporterKind{"junit", without_style<make_junit_reporter>},
                               ReporterKind{"tap", without_style<make_tap_reporter>},
                               ReporterKind{"json", without_style<make_json_reporter>},
                               ReporterKind{"jsonl", without_style<make_jsonl_reporter>},
                               ReporterKind{"github", without_style<make_github_reporter>}};

}  // namespace

std::vector<std::string> reporter_names() {
    std::vector<std::string> names;
    for (const ReporterKind& kind : kKinds) {
        names.emplace_back(kind.name);
    }
    return names;
}

std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style) {
    const auto kind = std::ranges::find(kKinds, name, &ReporterKind::name);
    return kind == kKinds.end() ? nullptr : kind->make(std::move(sink), style);
}

}  // namespace campuswalk::engine
