#include "engine/script/expectation.h"

#include <cstddef>
#include <utility>

namespace campuswalk::engine {

namespace {

template <std::size_t... index>
std::vector<std::string> plain_names(std::index_sequence<index...>) {
    return {std::string(std::variant_alternative_t<index, PlainExpectation>::kName)...};
}

}  // namespace

std::vector<std::string> failure_codes() {
    std::vector<std::string> codes = {"blocked", "enclosed", "timeout"};
    const std::vector<std::string> names =
        plain_names(std::make_index_sequence<std::variant_size_v<PlainExpectation>>());
    codes.insert(codes.end(), names.begin(), names.end());
    for (const std::string& name : names) {
        codes.push_back("not-" + name);
    }
    codes.emplace_back(ExpectLog::kName);
    return codes;
}

}  // namespace campuswalk::engine
