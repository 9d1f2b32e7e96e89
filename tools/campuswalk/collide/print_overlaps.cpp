#include "tools/campuswalk/collide/print_overlaps.h"

#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include "collision/mesh/mesh_collider.h"
#include "engine/events/decimals.h"

namespace campuswalk::tools::collide {

namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string described(const Body& body) {
    if (body.mesh() == nullptr) {
        return body.name;
    }
    const std::size_t count = body.mesh()->mesh().triangles.size();
    return body.name + " (" + std::to_string(count) + (count == 1 ? " triangle)" : " triangles)");
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string verdict(const Overlaps& overlaps, Told told) {
    if (!overlaps.any) {
        return overlaps.distance ? "apart: " + engine::fixed(*overlaps.distance, 6) + " m" : "apart";
    }
    if (overlaps.distance || told == Told::one) {
        return "overlapping";
    }
    return "overlapping: " + (overlaps.pairs.empty() ? counted(overlaps.triangles.size(), "triangle")
                                                     : counted(overlaps.pairs.size(), "triangle pair"));
}

/// Quoted as JSON does, so that a line stays a line whatever a node is called.
std::string quoted(const std::string& name) {
    return dumped(name, -1);
}

Json json_of(const Body& body) {
    Json json = {{"name", body.name}};
    if (body.mesh() != nullptr) {
        json["triangles"] = body.mesh()->mesh().triangles.size();
    }
    return json;
}

/// With Told::all or one: what overlaps, under the name that fits.
void add_list(Json& json, const Body& a, const Body& b, const Overlaps& overlaps) {
    if (a.mesh() != nullptr && b.mesh() != nullptr) {
        json["pairs"] = Json::array();
        for (const collision::TrianglePair& pair : overlaps.pairs) {
            json["pairs"].push_back(
                {{"a", pair.a}, {"b", pair.b}, {"a_node", a.node_of(pair.a)}, {"b_node", b.node_of(pair.b)}});
        }
        return;
    }
    const char* side = a.mesh() != nullptr ? "a" : "b";
    const Body& body = a.mesh() != nullptr ? a : b;
    json["triangles"] = Json::array();
    for (const std::uint32_t t : overlaps.triangles) {
        json["triangles"].push_back({{side, t}, {std::string(side) + "_node", body.node_of(t)}});
    }
}

}  // namespace

void print_text(const Body& a, const Body& b, const Overlaps& overlaps, Told told) {
    if (told == Told::count) {
        std::printf("%zu\n", overlaps.count());
        return;
    }
    std::printf("# a %s, b %s\n", described(a).c_str(), described(b).c_str());
    for (const collision::TrianglePair& pair : overlaps.pairs) {
        std::printf("a %u b %u %s %s\n", pair.a, pair.b, quoted(a.node_of(pair.a)).c_str(),
                    quoted(b.node_of(pair.b)).c_str());
    }
    const bool of_a = a.mesh() != nullptr;
    for (const std::uint32_t t : overlaps.triangles) {
        std::printf("%s %u %s\n", of_a ? "a" : "b", t, quoted((of_a ? a : b).node_of(t)).c_str());
    }
    std::printf("%s\n", verdict(overlaps, told).c_str());
}

void print_json(const Body& a, const Body& b, const Overlaps& overlaps, Told told) {
    Json json = {{"a", json_of(a)}, {"b", json_of(b)}, {"overlapping", overlaps.any}};
    if (told != Told::one) {
        json["count"] = overlaps.count();
    }
    if (overlaps.distance) {
        json["distance"] = *overlaps.distance;
    } else if (told != Told::count) {
        add_list(json, a, b, overlaps);
    }
    std::printf("%s\n", dumped(json, 2).c_str());
}

}  // namespace campuswalk::tools::collide
