#include "tests/engine/small_campus.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {

using collision::World;

scene::Campus empty_campus() {
    scene::Campus campus{{}, {}, {}, World(std::make_unique<collision::LinearBroadPhase>())};
    campus.description.name = "small";
    return campus;
}

scene::Campus level_campus(double half_size, collision::TreeKind tree) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh floor;
    support::add_floor(floor, half_size);
    add_object(campus, "ground", std::make_shared<const collision::MeshCollider>(std::move(floor), tree),
               Eigen::Vector3d::Zero());
    return campus;
}

scene::Campus walled_yard() {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "north", {-6.2, 0, -6.2}, {6.2, 4, -6});
    add_box(campus, "south", {-6.2, 0, 6}, {6.2, 4, 6.2});
    add_box(campus, "west", {-6.2, 0, -6}, {-6, 4, 6});
    add_box(campus, "east", {6, 0, -6}, {6.2, 4, 6});
    return campus;
}

scene::Campus walled_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3});
    return campus;
}

void add_building(scene::Campus& campus, const std::string& id, const std::string& title,
                  const std::string& hours, const std::string& text) {
    scene::Building building;
    building.id = id;
    building.title = title;
    building.hours = hours;
    building.text = text;
    campus.description.buildings.push_back(std::move(building));
}

collision::ObjectId add_object(scene::Campus& campus, const std::string& id, const collision::Shape& shape,
                               const Eigen::Vector3d& center, const ObjectTraits& traits) {
    std::vector<std::string>& layers = campus.description.layers;
    if (!traits.layer.empty() && std::ranges::find(layers, traits.layer) == layers.end()) {
        layers.push_back(traits.layer);
    }
    scene::CampusObject named;
    named.id = id;
    const auto& buildings = campus.description.buildings;
    if (const auto owner = std::ranges::find(buildings, traits.building, &scene::Building::id);
        owner != buildings.end()) {
        named.building = static_cast<std::size_t>(owner - buildings.begin());
        named.popup = traits.popup;
    }
    campus.objects.push_back(std::move(named));

    collision::Object object;
    object.shape = shape;
    object.X_world_shape.translation = center;
    object.detection = traits.detection;
    object.layer = campus.layer_index(traits.layer);
    return campus.world.add(std::move(object));
}

collision::ObjectId add_box(scene::Campus& campus, const std::string& id, const Eigen::Vector3d& min,
                            const Eigen::Vector3d& max, const ObjectTraits& traits) {
    return add_object(campus, id, collision::Box{0.5 * (max - min)}, 0.5 * (min + max), traits);
}

}  // namespace campuswalk::engine
