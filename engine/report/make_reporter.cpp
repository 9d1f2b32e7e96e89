#include "engine/report/make_reporter.h"

#include <utility>

#include "engine/report/reporters.h"

namespace campuswalk::engine {

std::vector<std::string> reporter_names() {
    return {"list", "dot", "junit", "tap", "json", "jsonl", "github"};
}

std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style) {
    if (name == "list") {
        return make_list_reporter(std::move(sink), style);
    }
    if (name == "dot") {
        return make_dot_reporter(std::move(sink), style);
    }
    if (name == "junit") {
        return make_junit_reporter(std::move(sink));
    }
    if (name == "tap") {
        return make_tap_reporter(std::move(sink));
    }
    if (name == "json") {
        return make_json_reporter(std::move(sink));
    }
    if (name == "jsonl") {
        return make_jsonl_reporter(std::move(sink));
    }
    if (name == "github") {
        return make_github_reporter(std::move(sink));
    }
    return nullptr;
}

}  // namespace campuswalk::engine
