#include "scene/osm/read/map.h"

#include <algorithm>
#include <iterator>

namespace campuswalk::scene::osm {

Tags::Tags(std::vector<std::pair<std::string, std::string>> pairs) : pairs_(std::move(pairs)) {
    std::ranges::stable_sort(pairs_, {}, &std::pair<std::string, std::string>::first);
}

std::string_view Tags::get(std::string_view key) const {
    const auto found = std::ranges::lower_bound(
        pairs_, key, {}, [](const auto& pair) { return std::string_view(pair.first); });
    return found != pairs_.end() && found->first == key ? std::string_view(found->second)
                                                        : std::string_view();
}

Tags Tags::with(const Tags& others) const {
    std::vector<std::pair<std::string, std::string>> pairs = pairs_;
    std::ranges::copy_if(others.pairs_, std::back_inserter(pairs),
                         [&](const auto& pair) { return !has(pair.first); });
    return Tags(std::move(pairs));
}

std::string ElementId::text() const {
    const char* word = kind == ElementKind::node ? "node-" : kind == ElementKind::way ? "way-" : "relation-";
    std::string digits = std::to_string(number);
    if (digits.front() == '-') {
        digits.front() = 'n';
    }
    return word + digits;
}

Box box_of(const std::vector<Point>& points) {
    Box box{points.front(), points.front()};
    for (const Point& p : points) {
        box.extend(p);
    }
    return box;
}

}  // namespace campuswalk::scene::osm
