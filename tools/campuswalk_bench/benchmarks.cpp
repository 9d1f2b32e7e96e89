#include "tools/campuswalk_bench/benchmarks.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <stdexcept>

#include "engine/events/decimals.h"
#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk_bench/campus/campus_cases.h"
#include "tools/campuswalk_bench/import/import_cases.h"
#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/measure/targets.h"
#include "tools/campuswalk_bench/pairs/pair_runs.h"
#include "tools/campuswalk_bench/pairs/table1_case.h"
#include "tools/campuswalk_bench/trees/tree_cases.h"
#include "tools/campuswalk_bench/walk/walk_bench.h"

namespace campuswalk::tools {

using namespace bench;

namespace {

std::string line(const Row& row) {
    std::string text = row.case_name + ',' + (row.pairs ? std::to_string(*row.pairs) : "") + ',' +
                       row.engine + ',' + row.query + ',' + engine::fixed(row.least, 3) + ',' +
                       engine::fixed(row.median, 3) + ',';
    if (row.work) {
        text +=
            std::to_string(row.work->volume_tests) + ',' + std::to_string(row.work->primitive_tests) + ',';
    } else {
        text += ",,";
    }
    if (row.difference) {
        text += row.difference->none() ? "yes" : to_string(*row.difference);
    }
    return text + '\n';
}

/// case,pairs,engine,query,us_min,us_median,nv,np,set_equal: one line per row. `pairs` is empty for queries
/// that don't find overlapping pairs, nv and np where they aren't counted, and set_equal where nothing is
/// compared; else set_equal is `yes` or +EXTRA/-MISSING. In case `memory`, us_min and us_median are bytes per
/// triangle, as the query's name says. Throws std::runtime_error.
void write_csv(const std::vector<Row>& rows, const std::filesystem::path& file) {
    std::string text = "case,pairs,engine,query,us_min,us_median,nv,np,set_equal\n";
    for (const Row& row : rows) {
        text += line(row);
    }
    scene::write_file_atomically(file, text);
}

/// Prints the targets whose cases are among the rows, one per line: what was measured, and whether it reaches
/// them.
void print_summary(const std::vector<Row>& rows) {
    std::printf("\nCompared with the targets: the peer's least time over ours\n");
    std::vector<Verdict> verdicts;
    for (const Target& target : targets()) {
        if (std::any_of(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.case_name == target.case_name; })) {
            verdicts.push_back(verdict_on(target, rows));
        }
    }
    print_verdicts(verdicts, 65,
                   [](const Verdict& verdict) { std::printf("%7.2f%-3s", *verdict.value, verdict.unit); });
}

constexpr int kMillionFineness = 11;
constexpr int kLotsOfTwoMillion = 17;

int rounds_of(const BenchOptions& options, int default_rounds) {
    if (options.rounds > 0) {
        return options.rounds;
    }
    return options.quick ? 1 : default_rounds;
}

CaseResult table1(const BenchOptions& options) {
    return run_table1(rounds_of(options, 25), options.mixed, options.plot);
}

CaseResult million(const BenchOptions& options) {
    return run_pair_case(finer_scene(options.quick ? 2 : kMillionFineness), rounds_of(options, 7));
}

CaseResult nested(const BenchOptions& options) {
    return run_pair_case(nested_scene(), rounds_of(options, 25));
}

CaseResult trees(const BenchOptions& options) {
    return run_tree_cases(rounds_of(options, 9));
}

CaseResult campus(const BenchOptions& options) {
    return run_campus_cases(options.quick ? CampusSize{1, 100, 100, 50} : CampusSize{},
                            rounds_of(options, 11));
}

CaseResult import(const BenchOptions& options) {
    return run_import_cases(options.quick ? 1 : kLotsOfTwoMillion, rounds_of(options, 7), options.models);
}

constexpr BenchCommand kCommands[] = {
    {"table1",
     "The paper's Table I: a teapot that intersects a cylinder, with every variant of the tree and every "
     "other engine that is built"},
    {"million", "The same teapot and cylinder of a million triangles each, in one placement"},
    {"nested", "A cylinder within a cylinder, 2 cm apart all around"},
    {"trees", "Time to build the trees, and their memory"},
    {"campus", "Rays, avatars and closest points on a campus of half a million triangles"},
    {"import", "GLB files of 2 million triangles, read by the import's helper and by assimp"},
    {kBenchWalk,
     "The avatar's mover compared with Bullet's on campuses of up to 2 million triangles: goals reached, "
     "forbidden goals reached, and speed"},
    {kBenchExplore,
     "Everywhere that a body can walk to, beside Recast's navigation mesh, and random walks that try to get "
     "farther"},
    {kBenchDraw,
     "Pictures of campuses of half a million and two million triangles, compared with other programs that "
     "draw"},
};
// Without `walk`, `explore` and `draw`, which have other CSVs.
constexpr CaseResult (*kCases[])(const BenchOptions&) = {table1, million, nested, trees, campus, import};
static_assert(std::size(kCommands) == std::size(kCases) + 3);

void check_output(const std::filesystem::path& file) {
    if (const std::string why = file.empty() ? "" : why_file_unwritable(file); !why.empty()) {
        throw scene::InputError({file.string(), 0, 0}, "output-unwritable",
                                "the results can't be written here: " + why);
    }
}

/// Throws std::runtime_error in a build that can't draw.
void require_drawing() {
    if (!can_draw()) {
        throw std::runtime_error("this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
}

}  // namespace

std::span<const BenchCommand> bench_commands() {
    return kCommands;
}

int run_bench(const BenchOptions& options) {
    if (!options.plot.empty()) {
        require_drawing();
    }
    check_output(options.csv);
    check_output(options.plot);
    if (options.quick) {
        std::printf("Small scenes and few rounds: this shows that it works, not how fast it is.\n");
    }
    if (options.which == kBenchWalk) {
        const bool right = run_walk_bench(rounds_of(options, 7), options.quick, options.csv);
        return right ? kPass : kExpectationFailed;
    }
    if (options.which == kBenchExplore) {
        const bool right =
            run_explore_bench(rounds_of(options, 5), options.quick, options.csv, options.explore);
        return right ? kPass : kExpectationFailed;
    }
    if (options.which == kBenchDraw) {
        require_drawing();
        run_draw_bench(rounds_of(options, 5), options.quick, options.csv, options.draw);
        return kPass;
    }
    CaseResult all;
    for (std::size_t i = 0; i < std::size(kCases); ++i) {
        if (options.which == kBenchAll) {
            std::printf("\n== %s\n", kCommands[i].name);
        } else if (options.which != kCommands[i].name) {
            continue;
        }
        const CaseResult one = kCases[i](options);
        std::fflush(stdout);
        all.rows.insert(all.rows.end(), one.rows.begin(), one.rows.end());
        all.ours_right = all.ours_right && one.ours_right;
    }
    print_summary(all.rows);
    if (!options.csv.empty()) {
        write_csv(all.rows, options.csv);
    }
    return all.ours_right ? kPass : kExpectationFailed;
}

}  // namespace campuswalk::tools
