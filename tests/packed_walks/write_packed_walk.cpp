// `write_packed_walk WALK FILE`: packs the walk of a YAML file with its campus, for play_packed_walk on any
// machine.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_run.h"
#include "tests/packed_walks/packed_walk.h"

int main(int count, char** arguments) try {
    using namespace campuswalk;
    if (count != 3) {
        std::fputs("usage: write_packed_walk WALK FILE\n", stderr);
        return 2;
    }
    const std::filesystem::path config = std::filesystem::path(CAMPUSWALK_SOURCE_FOLDER) / "config";
    config::Run run = config::load_run(arguments[1], {{config / "avatars"}, {config / "lights"}});
    std::vector<scene::Diagnostic> warnings;
    const scene::Campus campus =
        scene::load_campus(*run.campus, collision::make_bullet_broad_phase(), warnings);
    run.walk.origin = campus.origin;
    const std::vector<std::byte> bytes = packed::pack_walk(campus, run.walk);
    std::ofstream file(arguments[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file ? 0 : 3;
} catch (const std::exception& error) {
    std::fprintf(stderr, "write_packed_walk: %s\n", error.what());
    return 2;
}
