// `play_packed_walk FILE`: plays what write_packed_walk wrote and prints its log. Needs only the core, so
// that it can be built for processors that the rest isn't built for.
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "engine/observers/text_log.h"
#include "engine/simulation/run_walk.h"
#include "tests/packed_walks/packed_walk.h"

int main(int count, char** arguments) try {
    using namespace campuswalk;
    if (count != 2) {
        std::fputs("usage: play_packed_walk FILE\n", stderr);
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    const packed::PackedWalk packed = packed::unpack_walk(std::as_bytes(std::span(bytes)));
    engine::TextLog log(
        [](std::string_view line) { std::printf("%.*s\n", static_cast<int>(line.size()), line.data()); });
    const std::array<engine::Observer*, 1> observers = {&log};
    return engine::run_walk(packed.campus, packed.walk, observers).passed ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "play_packed_walk: %s\n", error.what());
    return 2;
}
