#include "engine/script/expectation.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace campuswalk::engine {

namespace {

template <std::size_t... index>
std::vector<std::string> plain_names(std::index_sequence<index...>) {
    return {std::string(std::variant_alternative_t<index, PlainExpectation>::kName)...};
}

}  // namespace

bool is_lack(std::string_view code) {
    return std::ranges::find(kLackCodes, code) != kLackCodes.end();
}

std::vector<std::string> failure_codes() {
    std::vector<std::string> codes(kStopCodes.begin(), kStopCodes.end());
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

const PlainExpectation* plain_part(const Expectation& expectation) {
    struct {
        const PlainExpectation* operator()(const PlainExpectation& plain) const { return &plain; }
        const PlainExpectation* operator()(const ExpectNot& negation) const { return &negation.what; }
        const PlainExpectation* operator()(const ExpectLog&) const { return nullptr; }
        const PlainExpectation* operator()(const ExpectSnapshot&) const { return nullptr; }
        const PlainExpectation* operator()(const ExpectVisible&) const { return nullptr; }
    } part;
    return std::visit(part, expectation);
}

bool is_about_images(const Expectation& expectation) {
    struct {
        bool operator()(const PlainExpectation&) const { return false; }
        bool operator()(const ExpectNot&) const { return false; }
        bool operator()(const ExpectLog&) const { return false; }
        bool operator()(const ExpectSnapshot&) const { return true; }
        bool operator()(const ExpectVisible&) const { return true; }
    } about;
    return std::visit(about, expectation);
}

std::vector<Mention> mentions_of(const std::vector<Expectation>& expectations) {
    std::vector<Mention> all;
    for (const Expectation& expectation : expectations) {
        if (const PlainExpectation* plain = plain_part(expectation)) {
            std::ranges::move(std::visit([](const auto& each) { return each.mentions(); }, *plain),
                              std::back_inserter(all));
        }
    }
    return all;
}

std::vector<std::string> image_failure_codes() {
    const std::string visible(ExpectVisible::kName);
    return {std::string(ExpectSnapshot::kName), visible, "not-" + visible};
}

}  // namespace campuswalk::engine
