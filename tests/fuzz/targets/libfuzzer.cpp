// The targets as a libFuzzer program: `fuzz_targets --target=NAME [libFuzzer's options] CORPUS…`.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "tests/fuzz/targets/targets.h"

namespace {

const campuswalk::fuzz::Target* chosen = nullptr;

}  // namespace

// libFuzzer leaves options with two dashes to its user.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr std::string_view kOption = "--target=";
    for (const char* argument : std::span(*argv, static_cast<std::size_t>(*argc))) {
        if (std::string_view(argument).starts_with(kOption)) {
            chosen = campuswalk::fuzz::find_target(argument + kOption.size());
        }
    }
    if (chosen == nullptr) {
        std::fputs("name a target: --target=NAME; see tests/fuzz/targets\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    chosen->read({bytes, size});
    return 0;
}
