#include "config/loader/read_origin.h"

#include "config/loader/checked_map.h"
#include "config/loader/ranges.h"

namespace campuswalk::config {

using scene::CampusOrigin;
using scene::GeographicPlace;

namespace {

void read_at(const CheckedNode& node, CampusOrigin& origin) {
    if (!node.is_scalar()) {
        origin.origin.at = node.vector(kCoordinate).value_or(origin.origin.at);
        return;
    }
    origin.near = node.line() == "near";
    if (!origin.near) {
        node.diagnose("bad-value", "'at' must be near, or three numbers, as in [84000, 0, -447000]");
    }
}

}  // namespace

CampusOrigin read_origin(const CheckedNode& node) {
    CampusOrigin origin;
    CheckedMap map(node, "'origin'");
    if (const auto at = map.find("at")) {
        read_at(*at, origin);
    }
    GeographicPlace place;
    map.number("latitude_deg", kLatitude, place.latitude_deg);
    map.number("longitude_deg", kLongitude, place.longitude_deg);
    map.number("height", kCoordinate, place.height);
    if (map.has("latitude_deg") || map.has("longitude_deg") || map.has("height")) {
        map.require("latitude_deg");
        map.require("longitude_deg");
        origin.origin.geographic = place;
    }
    map.refuse_other_keys();
    return origin;
}

}  // namespace campuswalk::config
