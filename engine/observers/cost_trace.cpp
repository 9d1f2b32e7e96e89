#include "engine/observers/cost_trace.h"

#include <nlohmann/json.hpp>

#include "engine/events/decimals.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

constexpr int kCostTrack = 1;
constexpr int kClockTrack = 2;

std::string quoted(const std::string& text) {
    return scene::printable_json(
        nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string track_name(int track, const std::string& name) {
    return R"({"ph":"M","pid":1,"tid":)" + std::to_string(track) +
           R"(,"name":"thread_name","args":{"name":)" + quoted(name) + "}}";
}

double tests(const collision::QueryStatistics& cost) {
    return static_cast<double>(cost.sphere_tests + cost.box_tests + cost.primitive_tests);
}

std::string counts(const collision::QueryStatistics& cost) {
    return R"("sphere_tests":)" + std::to_string(cost.sphere_tests) + R"(,"box_tests":)" +
           std::to_string(cost.box_tests) + R"(,"triangle_tests":)" + std::to_string(cost.primitive_tests) +
           R"(,"transform_updates":)" + std::to_string(cost.transform_updates);
}

}  // namespace

void CostTrace::begin(const Walk& walk) {
    cost_so_far_ = 0.0;
    total_ = {};
    hybrid_ = walk.sim.tree == collision::TreeKind::hybrid;
    next_ = 0;
    began_ = last_ = clock_ ? clock_() : 0.0;
    sink_(R"({"displayTimeUnit":"ms","traceEvents":[)");
    sink_(track_name(kCostTrack, walk.name + ": tests, 1 us each"));
    if (clock_) {
        sink_("," + track_name(kClockTrack, walk.name + ": wall time"));
    }
}

void CostTrace::slice(const std::string& name, int track, double start, double duration,
                      const std::string& details) {
    sink_(R"(,{"ph":"X","pid":1,"tid":)" + std::to_string(track) + R"(,"name":)" + quoted(name) +
          R"(,"ts":)" + fixed(start, 3) + R"(,"dur":)" + fixed(duration, 3) + R"(,"args":{)" + details +
          "}}");
}

/// Returns where the next one begins.
double CostTrace::stage(const char* name, double start, const collision::QueryStatistics& cost) {
    slice(name, kCostTrack, start, tests(cost), counts(cost));
    return start + tests(cost);
}

void CostTrace::on_tick(const TickRecord& record) {
    const double start = cost_so_far_;
    if (record.tick >= next_) {  // a walk's closing record repeats its last tick
        next_ = record.tick + 1;
        collision::QueryStatistics all = record.costs.move;
        all += record.costs.detect;
        total_ += all;
        const std::string when =
            R"("tick":)" + std::to_string(record.tick) + R"(,"time":)" + fixed(record.time, 6);
        cost_so_far_ += tests(all) + 1.0;
        slice("tick", kCostTrack, start, cost_so_far_ - start, when + "," + counts(all));
        stage("sense", stage("move", start, record.costs.move), record.costs.detect);
        if (clock_) {
            const double now = clock_();
            slice("tick", kClockTrack, last_ - began_, now - last_, when);
            last_ = now;
        }
    }
    for (const Event& event : record.events) {
        sink_(R"(,{"ph":"i","s":"t","pid":1,"tid":1,"name":)" +
              quoted(std::string(name_of(event.kind)) + " " + event.object) + R"(,"ts":)" + fixed(start, 3) +
              "}");
    }
}

/// The terms of eq. (4). In the hybrid tree, a node whose sphere the query overlaps has its box tested, too:
/// the others were decided by eq. (1) alone.
void CostTrace::end() {
    std::string terms =
        std::string(R"("tree":)") + (hybrid_ ? R"("hybrid")" : R"("bvh8")") + R"(,"Nv":)" +
        std::to_string(total_.volume_tests) + R"(,"Np":)" + std::to_string(total_.primitive_tests) +
        R"(,"Nu":)" + std::to_string(total_.transform_updates) + R"(,"sphere_tests":)" +
        std::to_string(total_.sphere_tests) + R"(,"box_tests":)" + std::to_string(total_.box_tests);
    if (hybrid_) {
        terms += R"(,"decided_by_eq_1":)" + std::to_string(total_.sphere_tests - total_.box_tests);
    }
    if (clock_) {
        terms += R"(,"wall_time_us":)" + fixed(last_ - began_, 3);
    }
    sink_(R"(],"otherData":{)" + terms + "}}");
}

}  // namespace campuswalk::engine
