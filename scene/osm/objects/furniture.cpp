#include "scene/osm/objects/furniture.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/meaning/triggers.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/path_nodes.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kBark = {{104, 82, 60}, 250, 255};
constexpr Look kLeaves = {{84, 124, 62}, 250, 255};
constexpr Look kConifer = {{58, 96, 66}, 250, 255};
constexpr Look kWood = {{150, 112, 72}, 230, 255};
constexpr Look kSteel = {{112, 116, 120}, 140, 255};
constexpr Look kDark = {{70, 74, 78}, 200, 255};
constexpr Look kLamp = {{240, 236, 214}, 120, 255};
constexpr Look kStone = {{188, 184, 176}, 235, 255};
constexpr Look kYellow = {{214, 176, 48}, 200, 255};
constexpr Look kBlue = {{60, 96, 150}, 200, 255};
constexpr Look kWater = {{110, 158, 180}, 60, 255};

/// Where a thing stands and which way it faces.
struct Place {
    Point at = Point::Zero();
    Point facing = Point(0, 1);
    double ground = 0.0;
    const Tags& tags;

    Point left() const { return {-facing.y(), facing.x()}; }
};

void add_tree(const Place& place, ObjectMesh& mesh) {
    const double height = std::clamp(length_of(place.tags, "height").value_or(7.0), 2.0, 60.0);
    const double radius =
        std::clamp(length_of(place.tags, "diameter_crown").value_or(0.5 * height) * 0.5, 0.5, 15.0);
    const double trunk = std::clamp(0.02 * height, 0.08, 0.6);
    const double crown = place.ground + std::max(2.3, 0.3 * height);  // visitors walk under it
    const double top = std::max(place.ground + height, crown + 1.0);
    mesh.cylinder(kBark, place.at, trunk, 0.8 * trunk, 6, place.ground - 0.3, crown + 0.3);
    if (place.tags.is("leaf_type", "needleleaved")) {
        mesh.cylinder(kConifer, place.at, radius * 0.8, 0.0, 8, crown, top);
        return;
    }
    const double a = crown + 0.3 * (top - crown);
    const double b = crown + 0.7 * (top - crown);
    mesh.cylinder(kLeaves, place.at, 0.55 * radius, radius, 8, crown, a);
    mesh.cylinder(kLeaves, place.at, radius, 0.85 * radius, 8, a, b);
    mesh.cylinder(kLeaves, place.at, 0.85 * radius, 0.25 * radius, 8, b, top);
}

void add_shrub(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kLeaves, place.at, 0.45, 0.55, 7, place.ground - 0.1, place.ground + 0.5);
    mesh.cylinder(kLeaves, place.at, 0.55, 0.15, 7, place.ground + 0.5, place.ground + 1.0);
}

void add_bench(const Place& place, ObjectMesh& mesh) {
    mesh.box(kWood, place.at, place.left(), Point(0.8, 0.22), place.ground + 0.38, place.ground + 0.45);
    for (const double side : {0.6, -0.6}) {
        mesh.box(kDark, place.at + side * place.left(), place.left(), Point(0.04, 0.2), place.ground - 0.1,
                 place.ground + 0.38);
    }
    if (!place.tags.is("backrest", "no")) {
        mesh.box(kWood, place.at - 0.2 * place.facing, place.left(), Point(0.8, 0.03), place.ground + 0.45,
                 place.ground + 0.85);
    }
}

void add_lamp(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kSteel, place.at, 0.08, 0.05, 6, place.ground - 0.2, place.ground + 4.6);
    mesh.cylinder(kLamp, place.at, 0.12, 0.22, 6, place.ground + 4.6, place.ground + 5.0);
}

void add_pole(const Place& place, ObjectMesh& mesh) {
    const double height = std::clamp(length_of(place.tags, "height").value_or(8.0), 1.0, 60.0);
    mesh.cylinder(kWood, place.at, 0.13, 0.09, 6, place.ground - 0.3, place.ground + height);
}

void add_flagpole(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kSteel, place.at, 0.07, 0.04, 6, place.ground - 0.2, place.ground + 9.0);
    mesh.box(kBlue, place.at + 0.8 * place.facing, place.facing, Point(0.75, 0.02), place.ground + 7.7,
             place.ground + 8.8);
}

void add_bin(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kDark, place.at, 0.2, 0.24, 8, place.ground - 0.05, place.ground + 0.85);
}

void add_box(const Place& place, ObjectMesh& mesh) {
    const bool post = place.tags.is("amenity", "post_box");
    const Look look = post ? kYellow : kBlue;
    mesh.box(look, place.at, place.left(), Point(post ? 0.25 : 0.4, 0.25), place.ground - 0.1,
             place.ground + (post ? 1.3 : 1.8));
}

void add_bicycle_stands(const Place& place, ObjectMesh& mesh) {
    const double capacity = std::clamp(number_of(place.tags, "capacity").value_or(8.0), 2.0, 40.0);
    const int stands = static_cast<int>(0.5 * capacity);
    for (int i = 0; i < stands; ++i) {
        const Point at = place.at + 0.9 * (i - 0.5 * (stands - 1)) * place.left();
        for (const double end : {0.35, -0.35}) {
            mesh.box(kSteel, at + end * place.facing, place.facing, Point(0.025, 0.025), place.ground - 0.1,
                     place.ground + 0.8);
        }
        mesh.box(kSteel, at, place.facing, Point(0.375, 0.025), place.ground + 0.75, place.ground + 0.8);
    }
}

void add_stop_sign(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kSteel, place.at, 0.04, 0.04, 6, place.ground - 0.2, place.ground + 2.6);
    mesh.box(kYellow, place.at + 0.3 * place.left(), place.left(), Point(0.28, 0.02), place.ground + 2.1,
             place.ground + 2.6);
}

void add_board(const Place& place, ObjectMesh& mesh) {
    for (const double side : {0.5, -0.5}) {
        mesh.box(kSteel, place.at + side * place.left(), place.left(), Point(0.03, 0.03), place.ground - 0.2,
                 place.ground + 1.9);
    }
    mesh.box(kStone, place.at, place.left(), Point(0.5, 0.025), place.ground + 0.9, place.ground + 1.9);
}

void add_statue(const Place& place, ObjectMesh& mesh) {
    mesh.box(kStone, place.at, place.facing, Point(0.45, 0.45), place.ground - 0.2, place.ground + 0.9);
    mesh.cylinder(kDark, place.at, 0.3, 0.2, 8, place.ground + 0.9, place.ground + 2.0);
    mesh.cylinder(kDark, place.at, 0.1, 0.16, 8, place.ground + 2.0, place.ground + 2.4);
}

void add_fountain(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder(kStone, place.at, 1.5, 1.5, 12, place.ground - 0.2, place.ground + 0.45);
    mesh.cylinder(kWater, place.at, 1.3, 1.3, 12, place.ground + 0.45, place.ground + 0.5);
    mesh.cylinder(kStone, place.at, 0.2, 0.15, 8, place.ground + 0.5, place.ground + 1.3);
}

void add_hydrant(const Place& place, ObjectMesh& mesh) {
    mesh.cylinder({{180, 50, 44}, 180, 255}, place.at, 0.13, 0.1, 8, place.ground - 0.1, place.ground + 0.75);
}

struct Thing {
    std::string_view key;
    std::string_view value;
    std::string_view name;  ///< of its nodes
    void (*add)(const Place&, ObjectMesh&);
    double radius = 0.4;  ///< metres around its middle that it takes, below heads
};

constexpr std::array<Thing, 28> kThings = {{
    {"natural", "tree", "tree", add_tree},
    {"natural", "shrub", "shrub", add_shrub, 0.6},
    {"amenity", "bench", "bench", add_bench, 1.0},
    {"leisure", "picnic_table", "bench", add_bench, 1.0},
    {"highway", "street_lamp", "lamp", add_lamp},
    {"man_made", "utility_pole", "pole", add_pole},
    {"power", "pole", "pole", add_pole},
    {"man_made", "mast", "pole", add_pole},
    {"man_made", "flagpole", "flagpole", add_flagpole},
    {"amenity", "waste_basket", "bin", add_bin},
    {"amenity", "recycling", "recycling", add_box},
    {"amenity", "post_box", "post-box", add_box},
    {"amenity", "vending_machine", "vending-machine", add_box},
    {"amenity", "telephone", "telephone", add_box},
    {"amenity", "parcel_locker", "parcel-locker", add_box},
    {"amenity", "atm", "atm", add_box},
    {"man_made", "street_cabinet", "cabinet", add_box},
    {"power", "cabinet", "cabinet", add_box},
    {"amenity", "bicycle_parking", "bicycle-stand", add_bicycle_stands, 4.0},
    {"highway", "bus_stop", "stop-sign", add_stop_sign},
    {"railway", "tram_stop", "stop-sign", add_stop_sign},
    {"amenity", "taxi", "stop-sign", add_stop_sign},
    {"tourism", "information", "board", add_board, 0.6},
    {"tourism", "artwork", "artwork", add_statue, 0.5},
    {"historic", "memorial", "memorial", add_statue, 0.5},
    {"historic", "monument", "memorial", add_statue, 0.5},
    {"amenity", "fountain", "fountain", add_fountain, 1.5},
    {"emergency", "fire_hydrant", "hydrant", add_hydrant},
}};

const Thing* thing_of(const Tags& tags) {
    const auto* found =
        std::ranges::find_if(kThings, [&](const Thing& thing) { return tags.is(thing.key, thing.value); });
    return found == kThings.end() ? nullptr : found;
}

Point facing_of(const Tags& tags, const Point& otherwise) {
    const auto direction = direction_of(tags, "direction");
    if (!direction) {
        return otherwise;
    }
    const collision::SinCos angle = collision::sin_cos(*direction * kDegree);
    return {angle.sin, angle.cos};
}

class Furniture {
public:
    Furniture(const Site& site, ModelBuilder& model)
        : site_(site), model_(model), on_path_(path_nodes(site.paths)), volumes_(index_of_volumes(site)) {}

    void add_nodes() {
        for (const MapNode& node : site_.map.nodes) {
            const Thing* thing = thing_of(node.tags);
            if (thing == nullptr || !site_.map.box.contains(node.at) || node.tags.has("level")) {
                continue;
            }
            Point at = node.at;
            Point along(1, 0);
            if (const auto found = on_path_.find(node.id); found != on_path_.end()) {
                // The sign of a stop on the carriageway is beside it.
                along = found->second.along;
                constexpr double kBeside = 0.6;
                at += (0.5 * found->second.path->width + kBeside) * Point(along.y(), -along.x());
            }
            add(*thing, ElementId{ElementKind::node, node.id}.text(), at, node.tags,
                Point(-along.y(), along.x()));
        }
    }

    void add_tree_rows() {
        constexpr double kSpacing = 8.0;
        constexpr std::size_t kMost = 2'000;
        for (const MapWay& way : site_.map.ways) {
            if (!way.tags.is("natural", "tree_row")) {
                continue;
            }
            std::size_t number = 0;
            for (std::size_t i = 1; i < way.points.size(); ++i) {
                const Point d = way.points[i] - way.points[i - 1];
                const double length = norm(d);
                const int trees = std::max(1, static_cast<int>(std::min(length / kSpacing, 1e4)));
                for (int k = 0; k < trees && number < kMost; ++k) {
                    const Point at = way.points[i - 1] + d * (static_cast<double>(k) / trees);
                    if (site_.map.box.contains(at)) {
                        add(kThings[0],
                            ElementId{ElementKind::way, way.id}.text() + "/" + std::to_string(++number), at,
                            way.tags, Point(0, 1));
                    }
                }
            }
        }
    }

    Built built() {
        for (const std::string& kind : kinds_) {
            built_.solids.push_back({kind, {kind + "/*"}, "", kind, true});
        }
        return std::move(built_);
    }

private:
    void add(const Thing& thing, const std::string& id, const Point& at, const Tags& tags,
             const Point& facing) {
        if (volume_at(site_, volumes_, at) != nullptr) {
            return;
        }
        const Place place{at, facing_of(tags, facing), site_.terrain.height(at), tags};
        thing.add(place, model_.object(std::string(thing.name) + "/" + id));
        kinds_.insert(std::string(thing.name));
        built_.add_obstacle(at, thing.radius);
    }

    const Site& site_;
    ModelBuilder& model_;
    Built built_;
    std::unordered_map<std::int64_t, PathNode> on_path_;
    BoxIndex volumes_;
    std::set<std::string> kinds_;
};

}  // namespace

Built add_furniture(const Site& site, ModelBuilder& model) {
    Furniture furniture(site, model);
    furniture.add_nodes();
    furniture.add_tree_rows();
    return furniture.built();
}

}  // namespace campuswalk::scene::osm
