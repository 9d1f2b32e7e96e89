// Reads every file of `CORPUS/TARGET/` with its target, without libFuzzer: `replay_corpus CORPUS`. What
// fuzzing has found once must not come back, and targets that only fuzzing builds would rot.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/targets/targets.h"

namespace fs = std::filesystem;

using campuswalk::fuzz::Target;

namespace {

std::size_t replay(const Target& target, const fs::path& folder) {
    std::set<fs::path> files(fs::directory_iterator(folder), {});
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
        std::printf("%s/%s\n", target.name, file.filename().c_str());  // a crash ends the list
        std::fflush(stdout);
        target.read({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }
    return files.size();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: replay_corpus CORPUS\n", stderr);
        return 2;
    }
    std::size_t missing = 0;
    for (const auto& targets : {campuswalk::fuzz::model_targets(), campuswalk::fuzz::map_targets(),
                                campuswalk::fuzz::archive_targets(), campuswalk::fuzz::text_targets()}) {
        for (const Target& target : targets) {
            const fs::path folder = fs::path(argv[1]) / target.name;
            if (!fs::is_directory(folder) || replay(target, folder) == 0) {
                std::fprintf(stderr, "there is no corpus for %s\n", target.name);
                ++missing;
            }
        }
    }
    return missing == 0 ? 0 : 1;
}
