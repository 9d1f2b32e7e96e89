#include "tests/scene/osm/map_text.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace campuswalk::scene::test {
namespace {

/// From -180 to 180, as the database has them.
double meridian(double longitude) {
    return longitude > 180.0 ? longitude - 360.0 : longitude < -180.0 ? longitude + 360.0 : longitude;
}

}  // namespace

MapText::MapText(double half_size, double latitude, double longitude)
    : half_size_(half_size), latitude_(latitude), longitude_(longitude) {
    // The ellipsoid's radii of curvature (WGS 84): of the meridian and of the prime vertical.
    const double a = 6378137.0;
    const double f = 1.0 / 298.257223563;
    const double e2 = f * (2.0 - f);
    const double sin = std::sin(latitude * std::numbers::pi / 180.0);
    const double w = std::sqrt(1.0 - e2 * sin * sin);
    degrees_north_ = 180.0 / std::numbers::pi / (a * (1.0 - e2) / (w * w * w));
    degrees_east_ = 180.0 / std::numbers::pi / (a / w * std::cos(latitude * std::numbers::pi / 180.0));
}

std::string MapText::tags_xml(const Tags& tags) const {
    std::string text;
    for (const auto& [key, value] : tags) {
        text.append("  <tag k=\"").append(key).append("\" v=\"").append(value).append("\"/>\n");
    }
    return text;
}

std::int64_t MapText::node(double east, double north, const Tags& tags) {
    char at[128];
    std::snprintf(at, sizeof at, "lat=\"%.9f\" lon=\"%.9f\"", latitude_ + north * degrees_north_,
                  meridian(longitude_ + east * degrees_east_));
    nodes_ += " <node id=\"" + std::to_string(++last_) + "\" " + at + ">\n" + tags_xml(tags) + " </node>\n";
    return last_;
}

std::int64_t MapText::way_of(const std::vector<std::int64_t>& nodes, const Tags& tags) {
    std::string refs;
    for (const std::int64_t node : nodes) {
        refs += "  <nd ref=\"" + std::to_string(node) + "\"/>\n";
    }
    ways_ += " <way id=\"" + std::to_string(++last_) + "\">\n" + refs + tags_xml(tags) + " </way>\n";
    return last_;
}

std::int64_t MapText::way(const Points& points, const Tags& tags) {
    std::vector<std::int64_t> nodes;
    for (const auto& [east, north] : points) {
        nodes.push_back(node(east, north));
    }
    return way_of(nodes, tags);
}

std::int64_t MapText::ring(const Points& points, const Tags& tags) {
    std::vector<std::int64_t> nodes;
    for (const auto& [east, north] : points) {
        nodes.push_back(node(east, north));
    }
    nodes.push_back(nodes.front());
    return way_of(nodes, tags);
}

std::int64_t MapText::rectangle(double west, double south, double east, double north, const Tags& tags) {
    return ring({{west, south}, {east, south}, {east, north}, {west, north}}, tags);
}

std::int64_t MapText::relation(const std::vector<std::pair<std::int64_t, std::string>>& members,
                               const Tags& tags) {
    relations_ += " <relation id=\"" + std::to_string(++last_) + "\">\n";
    for (const auto& [way, role] : members) {
        relations_ += "  <member type=\"way\" ref=\"" + std::to_string(way) + "\" role=\"" + role + "\"/>\n";
    }
    relations_ += tags_xml(tags) + " </relation>\n";
    return last_;
}

std::string MapText::xml() const {
    char bounds[200];
    std::snprintf(bounds, sizeof bounds,
                  " <bounds minlat=\"%.9f\" minlon=\"%.9f\" maxlat=\"%.9f\" maxlon=\"%.9f\"/>\n",
                  latitude_ - half_size_ * degrees_north_, meridian(longitude_ - half_size_ * degrees_east_),
                  latitude_ + half_size_ * degrees_north_, meridian(longitude_ + half_size_ * degrees_east_));
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\">\n" + std::string(bounds) +
           nodes_ + ways_ + relations_ + "</osm>\n";
}

}  // namespace campuswalk::scene::test
