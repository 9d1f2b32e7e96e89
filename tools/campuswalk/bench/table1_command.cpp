#include "tools/campuswalk/bench/table1_command.h"

#include <cstdio>
#include <stdexcept>

#include "scene/diagnostic.h"
#include "scene/procedural/table1_scene.h"
#include "tools/campuswalk/bench/figure4.h"
#include "tools/campuswalk/bench/our_engines.h"
#include "tools/campuswalk/bench/peer_engines.h"
#include "tools/campuswalk/bench/print_table1.h"
#include "tools/campuswalk/bench/shuffled_runs.h"
#include "tools/campuswalk/bench/write_csv.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/writable_path.h"

namespace campuswalk::tools {

using namespace bench;

namespace {

void check_output(const std::filesystem::path& file) {
    if (const std::string why = file.empty() ? "" : why_file_unwritable(file); !why.empty()) {
        throw scene::InputError({file.string(), 0, 0}, "output-unwritable",
                                "the results can't be written here: " + why);
    }
}

/// What is wrong with our own engines; a line each to standard error.
bool complain_about_ours(const Results& results) {
    bool any = false;
    for (std::size_t i = 0; i < results.pairs.size(); ++i) {
        if (results.found[i] != results.pairs[i]) {
            any = true;
            std::fprintf(stderr, "error: %s finds %zu pairs where Table I has %u\n",
                         results.engines.front().name.c_str(), results.found[i], results.pairs[i]);
        }
    }
    for (const Measurement& m : results.measurements) {
        const EngineName& engine = results.engines[m.engine];
        if (engine.is_ours && !m.difference.none()) {
            any = true;
            std::fprintf(stderr, "error: at %u pairs %s differs from %s by %s\n", results.pairs[m.placement],
                         engine.name.c_str(), results.engines.front().name.c_str(),
                         to_string(m.difference).c_str());
        }
    }
    return any;
}

}  // namespace

int bench_table1(const Table1Options& options) {
    if (!options.plot.empty() && !can_plot()) {
        throw std::runtime_error("this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
    check_output(options.csv);
    check_output(options.plot);
    const scene::Table1Scene scene = scene::table1_scene();
    std::vector<NamedEngine> engines = our_engines(scene.cylinder, scene.teapot);
    Peers peers = load_peers(scene.cylinder, scene.teapot);
    for (NamedEngine& peer : peers.engines) {
        engines.push_back(std::move(peer));
    }
    const Results results = measure(scene, engines, options.rounds);

    std::printf("A teapot of %zu triangles goes through a cylinder of %zu.\n", scene.teapot.triangles.size(),
                scene.cylinder.triangles.size());
    print_table1(results);
    for (const std::string& absent : peers.absent) {
        std::printf("  absent: %s\n", absent.c_str());
    }
    if (!options.csv.empty()) {
        write_csv(results, options.csv);
    }
    if (!options.plot.empty()) {
        plot_figure4(results, options.plot);
    }
    return complain_about_ours(results) ? kExpectationFailed : kPass;
}

}  // namespace campuswalk::tools
