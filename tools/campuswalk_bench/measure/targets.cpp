#include "tools/campuswalk_bench/measure/targets.h"

#include <algorithm>
#include <string>

#include "tools/campuswalk_bench/measure/measurement.h"

namespace campuswalk::tools::bench {

namespace {

using enum Measure;

// The targets from the plan of the BVH8. FCL took 316 bytes per triangle then.
constexpr Target kTargets[] = {
    {"all contacts", "table1", "all", "wide_avx2", "fcl_obb", mean_ratio, 20, 35},
    {"all contacts", "table1", "all", "wide_avx2", "bullet_gimpact", mean_ratio, 25, 45},
    {"all contacts", "table1", "all", "wide_avx2", "ode", mean_ratio, 12, 22},
    {"all contacts", "table1", "all", "wide_avx2", "embree", mean_ratio, 16, 28},
    {"all contacts", "table1", "all", "wide_sse42", "fcl_obb", mean_ratio, 12, 17},
    {"all contacts", "table1", "all", "wide_avx512", "fcl_obb", mean_ratio, 24, 42},
    {"all contacts", "table1", "all", "paper", "fcl_obb", mean_ratio, 2.5, {}},
    {"first contact", "table1", "first", "wide_avx2", "fcl_obb", mean_ratio, 8, 12},
    {"first contact, worst", "table1", "first", "wide_avx2", "fcl_obb", worst_ratio, 1, {}},
    {"a million triangles", "million", "all", "wide_avx2", "fcl_obb", mean_ratio, 10, 20},
    {"nested cylinders", "nested", "all", "wide_avx2", "fcl_obb", mean_ratio, 5, 10},
    {"build", "build", "build", "wide", "fcl_obb", mean_ratio, 4.4, 9},
    {"memory, bytes per triangle", "memory", "heap_bytes", "wide", "", figure, 96, 48},
    // At most one and a half times assimp's time: ours runs in a separate process with limits.
    {"import of 2M triangles", "import", "glb", "helper", "assimp", mean_ratio, 0.667, {}},
    {"import without normals", "import", "glb_without_normals", "helper", "assimp", mean_ratio, 0.667, {}},
    {"rays of 200 m", "rays", "first_hit", "wide", "embree_robust", mean_ratio, 0.5, 1},
};

/// By placement, in the order of the case.
std::vector<double> least_figures(const Target& target, const std::string& engine,
                                  const std::vector<Row>& rows) {
    std::vector<double> figures;
    for (const Row& row : rows) {
        if (row.case_name == target.case_name && row.query == target.query && row.engine == engine) {
            figures.push_back(row.least);
        }
    }
    return figures;
}

/// Empty if one of the engines wasn't measured.
std::optional<double> measured(const Target& target, const std::vector<Row>& rows) {
    const std::vector<double> ours = least_figures(target, target.ours, rows);
    if (ours.empty()) {
        return std::nullopt;
    }
    if (target.measure == figure) {
        return ours.front();
    }
    std::vector<double> ratios = least_figures(target, target.peer, rows);
    if (ratios.size() != ours.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        ratios[i] /= ours[i];
    }
    return target.measure == worst_ratio ? *std::min_element(ratios.begin(), ratios.end())
                                         : geometric_mean(ratios);
}

}  // namespace

std::span<const Target> targets() {
    return kTargets;
}

Verdict verdict_on(const Target& target, const std::vector<Row>& rows) {
    const bool is_ratio = target.measure != figure;
    std::string what = target.what;
    what.resize(28, ' ');  // a column
    what += target.ours + (is_ratio ? std::string(" against ") + target.peer : "") + ":";
    const auto value = measured(target, rows);
    return is_ratio ? at_least(what, value, "x", target.must, target.aim)
                    : at_most(what, value, "", target.must, target.aim);
}

}  // namespace campuswalk::tools::bench
