#include <utility>

#include <nlohmann/json.hpp>

#include "engine/report/reporters.h"
#include "engine/report/result_json.h"
#include "engine/report/result_text.h"

namespace campuswalk::engine {

namespace {

class JsonlReporter final : public Reporter {
public:
    explicit JsonlReporter(TextSink sink) : sink_(std::move(sink)) {}

    void begin(const RunPlan& plan) override { sink_(to_header_line(plan) + "\n"); }
    void result(const WalkResult& result) override { sink_(to_json_line(result) + "\n"); }

private:
    TextSink sink_;
};

class JsonReporter final : public Reporter {
public:
    explicit JsonReporter(TextSink sink) : sink_(std::move(sink)) {}

    void begin(const RunPlan& plan) override { plan_ = plan; }
    void result(const WalkResult& result) override { tally_.add(result); }

    void end(const ResultSequence& results) override {
        sink_("{\"campuswalk_report\":1,\n\"plan\":" + to_json(plan_) +
              ",\n\"summary\":" + summary_json(tally_) + ",\n\"results\":[");
        const char* between = "\n";
        results.for_each([&](const WalkResult& result) {
            sink_(between + to_json_line(result));
            between = ",\n";
        });
        sink_("\n]}\n");
    }

private:
    static std::string summary_json(const Tally& tally) {
        return nlohmann::ordered_json{{"passed", tally.passed},
                                      {"failed", tally.failed},
                                      {"skipped", tally.skipped},
                                      {"bad_input", tally.bad_input},
                                      {"broken", tally.broken},
                                      {"interrupted", tally.interrupted},
                                      {"expected_failures", tally.expected_failures},
                                      {"not_evaluated", tally.not_evaluated},
                                      {"simulated_seconds", tally.seconds},
                                      {"distance", tally.distance}}
            .dump();
    }

    TextSink sink_;
    RunPlan plan_;
    Tally tally_;
};

}  // namespace

std::unique_ptr<Reporter> make_json_reporter(TextSink sink, const ReportStyle& /*style*/) {
    return std::make_unique<JsonReporter>(std::move(sink));
}

std::unique_ptr<Reporter> make_jsonl_reporter(TextSink sink, const ReportStyle& /*style*/) {
    return std::make_unique<JsonlReporter>(std::move(sink));
}

}  // namespace campuswalk::engine
