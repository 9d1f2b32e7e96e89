#include "config/loader/read_limits.h"

#include <string>

namespace campuswalk::config {

using engine::Limits;

namespace {

constexpr int kMostTimes = 1'000'000'000;

/// `read` gives the number of a node.
template <typename Number, typename Read>
void read_all(CheckedMap& map, std::string_view what, const Read& read, Limits<Number>& limits) {
    const auto read_one = [&](std::string_view key, std::optional<Number>& limit) {
        if (const auto value = map.find(key)) {
            limit = read(*value);
        }
    };
    read_one("equals", limits.equals);
    read_one("at_least", limits.at_least);
    read_one("at_most", limits.at_most);
    if (map.is_map() && !map.has("equals") && !map.has("at_least") && !map.has("at_most")) {
        map.diagnose("missing-key", std::string(what) + " needs one of equals, at_least, at_most");
    }
    if (limits.at_least && limits.at_most && *limits.at_least > *limits.at_most) {
        map.diagnose_at("at_most", "bad-value", "'at_most' is less than 'at_least'");
    }
}

template <typename Number, typename Read>
Limits<Number> read_either(const CheckedNode& node, const Read& read) {
    Limits<Number> limits;
    if (!node.is_map()) {
        limits.equals = read(node);
        return limits;
    }
    CheckedMap map(node, node.what());
    read_all(map, node.what(), read, limits);
    map.refuse_other_keys();
    return limits;
}

std::optional<int> read_times(const CheckedNode& node) {
    return node.whole_number(0, kMostTimes);
}

}  // namespace

void read_limits(CheckedMap& map, std::string_view what, Limits<int>& limits) {
    read_all(map, what, read_times, limits);
}

Limits<int> read_limits(const CheckedNode& node) {
    return read_either<int>(node, read_times);
}

Limits<double> read_limits(const CheckedNode& node, const Range& range) {
    return read_either<double>(node, [&](const CheckedNode& value) { return value.number(range); });
}

}  // namespace campuswalk::config
