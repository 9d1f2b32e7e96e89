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
    const std::vector<std::string> of_images = image_failure_codes();
    codes.insert(codes.end(), of_images.begin(), of_images.end());
    return codes;
}

std::string code_of(const ExpectVisible& expected) {
    return (expected.negated ? "not-" : "") + std::string(ExpectVisible::kName);
}

bool is_about_images(const Expectation& expectation) {
    return std::holds_alternative<ExpectSnapshot>(expectation) ||
           std::holds_alternative<ExpectVisible>(expectation);
}

std::vector<std::string> image_failure_codes() {
    const std::string visible(ExpectVisible::kName);
    return {std::string(ExpectSnapshot::kName), visible, "not-" + visible};
}

}  // namespace campuswalk::engine
