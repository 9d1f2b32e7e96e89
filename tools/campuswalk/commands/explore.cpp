#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>
#include <chrono>

#include "collision/world/bullet_broad_phase.h"
#include "engine/script/avatar_body.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/unreached_ground.h"
#include "engine/walkspace/island_barriers.h"
#include "engine/walkspace/barrier_text.h"
#include "engine/walkspace/storeys.h"
#include "engine/walkspace/one_way.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

namespace {

struct ExploreOptions {
    std::filesystem::path campus;
    int workers = 2;
    double step = 0.3;
    double slope = 50;
};

int explore_campus(const ExploreOptions& options) {
    WalkLoader loader;
    const auto campus = loader.load_campus(options.campus);
    engine::AvatarProfile avatar;
    avatar.step_height = options.step;
    avatar.max_slope = options.slope * 3.14159265358979 / 180;
    engine::ExploreSettings settings;
    settings.strides.body = engine::mover_settings(avatar);
    settings.strides.walk_speed = avatar.speed;
    settings.strides.run_speed = engine::running_speed(avatar);
    settings.keep_rim = true;
    settings.solids = {collision::Detection::solid, 0, nullptr};
    for (const auto& spawn : campus->description.spawns) settings.starts.push_back(spawn.position);
    const engine::WorkerWorlds worlds(campus->world, static_cast<std::size_t>(options.workers), collision::make_bullet_broad_phase);
    auto t0 = std::chrono::steady_clock::now();
    const engine::WalkSpace space = engine::explore(worlds, settings);
    double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    double top = -1e9, bottom = 1e9; std::uint64_t h = 1469598103934665603ull; std::size_t oneway = 0, drops = 0, bytes = 0;
    for (const auto& t : space.tiles) { for (const auto& n : t.nodes) { top = std::max<double>(top, n.y); bottom = std::min<double>(bottom, n.y); oneway += !n.returns;
        std::uint32_t b = 0; std::memcpy(&b, &n.y, 4); h = (h ^ b) * 1099511628211ull; h = (h ^ n.cell ^ static_cast<std::uint32_t>(n.direction) << 10U) * 1099511628211ull; } drops += t.drops.size(); bytes += sizeof t + t.nodes.capacity() * 12 + t.keyframes.capacity() * sizeof(t.keyframes[0]) + t.drops.capacity() * sizeof(t.drops[0]); }
    print_line("%zu nodes, %.1f m2, %.2f to %.2f, %lu strides, %lu ticks, %.3f s, %.3f us/tick, hash %016lx, one-way %zu, drops %zu, %.1f B/m2, starts %zu", space.node_count(), space.area(), bottom, top, space.strides, space.ticks, s, 1e6 * s / static_cast<double>(space.ticks), h, oneway, drops, static_cast<double>(bytes) / space.area(), space.starts.size());
    t0 = std::chrono::steady_clock::now();
    const auto islands = engine::find_unreached_ground(worlds, settings, space, 1.0);
    s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    print_line("islands %zu in %.3f s", islands.size(), s);
    t0 = std::chrono::steady_clock::now();
    const auto barriers = engine::find_island_barriers(worlds, settings, space, islands, 1000);
    s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    print_line("barriers %zu in %.3f s", barriers.size(), s);
    for (std::size_t i = 0; i < barriers.size(); ++i) {
        const auto& is = islands[i];
        print_line("  %.1f m2 y %.2f..%.2f at %.2f %.2f %.2f on %s: %s", is.area(space.grid), is.bounds.min.y(), is.bounds.max.y(), is.spots[0].at.foot.x(), is.spots[0].at.foot.y(), is.spots[0].at.foot.z(), engine::object_text(*campus, is.spots[0].object, is.spots[0].at.foot).c_str(), barriers[i] ? engine::barrier_text(*campus, *barriers[i]).c_str() : "nothing near");
    }
    for (const auto& st : engine::find_storeys(space).list) print_line("storey %.2f to %.2f: %.1f m2", st.low, st.high, st.area);
    t0 = std::chrono::steady_clock::now();
    const auto traps = engine::find_traps(worlds, settings, space);
    s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    print_line("traps %zu in %.3f s", traps.size(), s);
    for (const auto& t : traps) { auto p = space.position(t.entrance); print_line("  %.2f m2 at %.2f %.2f %.2f, drop %.2f", static_cast<double>(t.nodes.size()) * .0625, p.x(), p.y(), p.z(), t.drop); }
    for (const auto& hole : engine::find_holes(space)) { auto p = hole.edges[0].at; print_line("  hole %.2f m at %.2f %.2f %.2f", hole.length, p.x(), p.y(), p.z()); }
    return kPass;
}

}  // namespace

void add_explore(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<ExploreOptions>();
    Command command = program.add("explore", "Find out where a visitor can get to");
    command.option({.names = "CAMPUS", .help = "NAME.campus.yaml", .value = "FILE", .required = true}, options->campus);
    command.option({.names = "-j,--workers", .help = "Threads", .show_default = true}, options->workers, Limits<int>{1, 256});
    command.option({.names = "--step", .help = "Step", .show_default = true}, options->step, Limits<double>{0, 5});
    command.option({.names = "--slope", .help = "Slope", .show_default = true}, options->slope, Limits<double>{0, 90});
    add_import_options(command);
    add_root_option(command);
    command.choose(chosen, [options] { return explore_campus(*options); });
}

}  // namespace campuswalk::tools
