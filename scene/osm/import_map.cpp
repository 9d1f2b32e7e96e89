#include "scene/osm/import_map.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/osm/bridges/bridge_piers.h"
#include "scene/osm/bridges/bridges.h"
#include "scene/osm/bridges/decks.h"
#include "scene/osm/geometry/areas.h"
#include "scene/osm/geometry/box_index.h"
#include "scene/osm/geometry/heights.h"
#include "scene/osm/meaning/meaning.h"
#include "scene/osm/objects/barriers.h"
#include "scene/osm/objects/furniture.h"
#include "scene/osm/objects/steps.h"
#include "scene/osm/read/unreadable_lengths.h"
#include "scene/osm/ways/ground.h"
#include "scene/osm/ways/relief.h"
#include "scene/osm/ways/site.h"
#include "scene/osm/ways/surfaces.h"

namespace campuswalk::scene::osm {
namespace {

/// Adds the buildings, open where paths lead through them.
Built add_buildings(const Site& site, ModelBuilder& model) {
    Built built;
    constexpr double kLeastInside = 1.5;  // metres; less is a door
    const std::vector<Passage> passages = passages_of(site.paths, site.geometry);
    BoxIndex index;
    for (std::size_t i = 0; i < passages.size(); ++i) {
        if (!passages[i].area.empty()) {
            index.add(i, box_of(passages[i].area));
        }
    }
    for (const Volume& volume : site.volumes) {
        std::vector<const Passage*> through;
        if (!volume.open) {
            for (const std::size_t i : index.near(box_of(volume.footprint))) {
                const bool at_ground = !passages[i].floor.has_value();
                if ((!at_ground || volume.bottom < 2.0) &&
                    length_inside(passages[i].way->points, volume.footprint) > kLeastInside) {
                    through.push_back(&passages[i]);
                    if (at_ground) {
                        built.openings.push_back(passages[i].area);
                    }
                    if (at_ground && !passages[i].tagged && passages[i].for_walkers) {
                        site.warn("untagged-passage", "way " + std::to_string(passages[i].way->id) +
                                                          " runs through " + volume.node +
                                                          " without tunnel=building_passage; it is open");
                    }
                }
            }
        }
        add_volume(volume, through, site.geometry, site.terrain, model);
    }
    return built;
}

std::vector<Deck> decks_of(const BridgePlan& plan, const Site& site) {
    std::vector<Deck> decks;
    for (const Bridge& bridge : plan.bridges) {
        decks.push_back(deck_of(bridge, site));
    }
    return decks;
}

void trim_stairs(const std::vector<Deck>& decks, std::vector<Path>& paths) {
    for (const Deck& deck : decks) {
        for (const StairsTrim& trim : deck.trims) {
            (trim.first ? paths[trim.path].first_trim : paths[trim.path].last_trim) = trim.length;
        }
    }
}

Built add_bridges(const std::vector<Deck>& decks, const Site& site, ModelBuilder& model) {
    Built built;
    for (std::size_t i = 0; i < decks.size(); ++i) {
        add_deck(decks, i, site, model);
        for (const DeckPart& part : decks[i].parts) {
            built.obstacles.push_back(part.area);
        }
    }
    built.solids.push_back({"bridge", {"bridge/*"}, "", "bridge", true});
    built.append(add_piers(decks, site, model));
    return built;
}

Box on_grid(const Box& box) {
    return {{std::floor(box.min.x()), std::floor(box.min.y())},
            {std::ceil(box.max.x()), std::ceil(box.max.y())}};
}

/// The map's box, and as much around it as buildings that begin in it need.
Box ground_box(const Map& map, const std::vector<MapArea>& areas) {
    constexpr double kMargin = 5.0;
    constexpr double kFarthest = 250.0;
    const Box farthest = map.box.grown(kFarthest);
    Box box = map.box;
    for (const MapArea& area : areas) {
        if (is_building(area.tags)) {
            const Box around = box_of(area.polygons).grown(kMargin);
            for (const Point& p : {around.min, around.max}) {
                box.extend(p.cwiseMax(farthest.min).cwiseMin(farthest.max));
            }
        }
    }
    return on_grid(box);
}

/// From a grid of heights, or as steps make it.
Terrain base_terrain(const MapRequest& request, const Map& map, const std::vector<MapArea>& areas,
                     const Box& box, std::vector<Path>& paths) {
    if (request.heights.empty()) {
        DiagnosticList ignored;  // only to know which steps lead to bridges
        plan_bridges(map, areas, Terrain(), request.mark, paths, ignored);
        return relief_of_steps(paths, box);
    }
    SourceMark mark = request.heights_mark;
    mark.file = mark.file.empty() ? request.heights.string() : mark.file;
    return read_heights(request.heights, mark, map, box);
}

/// One object, as a visitor is always on one of its nodes.
std::vector<std::string> ground_globs(const std::vector<Surface>& surfaces) {
    std::set<std::string> kinds;
    for (const Surface& surface : surfaces) {
        kinds.insert(surface.name.substr(0, surface.name.find('/')));
    }
    std::vector<std::string> globs = {"ground", "kerbs"};
    for (const std::string& kind : kinds) {
        globs.push_back(kind + "/*");
    }
    return globs;
}

/// Leaves out what has no triangles after all: globs that match nothing are errors.
void keep_existing(const Model& model, std::vector<DraftSolid>& solids) {
    std::set<std::string> names;
    for (const Node& node : model.nodes) {
        names.insert(node.name);
    }
    const auto matches_none = [&](const std::string& glob) {
        if (!glob.ends_with("/*")) {
            return !names.contains(glob);
        }
        const std::string prefix = glob.substr(0, glob.size() - 1);
        const auto next = names.lower_bound(prefix);
        return next == names.end() || !next->starts_with(prefix);
    };
    for (DraftSolid& solid : solids) {
        std::erase_if(solid.globs, matches_none);
    }
    std::erase_if(solids, [](const DraftSolid& solid) { return solid.globs.empty(); });
}

/// A layer for each kind of solids and triggers, so that an avatar can ignore, say, trees.
std::vector<std::string> layers_of(const CampusDraft& draft) {
    std::set<std::string> layers;
    for (const DraftSolid& solid : draft.solids) {
        layers.insert(solid.layer);
    }
    for (const DraftTrigger& trigger : draft.triggers) {
        layers.insert(trigger.layer);
    }
    layers.erase("");
    return {layers.begin(), layers.end()};
}

/// The middle of the map with half its edges, as an example for messages.
std::string smaller_part(const Map& map) {
    const GeographicBox& box = map.geographic;
    const double longitude = 0.5 * (box.west + box.east);
    return "--center " + std::to_string(0.5 * (box.south + box.north)) + "," +
           std::to_string(longitude > 180.0 ? longitude - 360.0 : longitude) + " --radius " +
           std::to_string(static_cast<int>(std::ceil(0.25 * map.box.size().maxCoeff())));
}

Built add_surfaces(const Site& site, ModelBuilder& model) {
    const std::vector<Surface> surfaces =
        surfaces_of(site.map, site.paths, site.areas, site.geometry, site.terrain);
    add_ground(surfaces, site.ground, site.geometry, site.terrain, model);
    Built built;
    for (const Surface& surface : surfaces) {
        if (surface.water) {
            built.obstacles.push_back(surface.area);
        }
    }
    built.solids.push_back({"ground", ground_globs(surfaces), "", "ground", false});
    return built;
}

CampusDraft build(const Site& site, const std::vector<Deck>& decks, ModelBuilder& model) {
    Built built = add_bridges(decks, site, model);
    built.append(add_surfaces(site, model));
    built.append(add_steps(site, built, model));
    built.append(add_buildings(site, model));
    built.append(add_barriers(site, model));
    built.append(add_furniture(site, model));
    return meaning_of(site, std::move(built), model);
}

ImportedMap imported_map(const MapRequest& request, const Map& map, DiagnosticList& warnings) {
    report_unreadable_lengths(map, request.mark, warnings);
    const PlanGeometry geometry(OverlayBudget::for_map(map.nodes_read));
    std::vector<MapArea> areas = areas_of(map, geometry, request.mark, warnings);
    const Box box = ground_box(map, areas);
    std::vector<Path> paths = paths_of(map, areas, box, geometry);
    const Terrain base = base_terrain(request, map, areas, box, paths);
    const BridgePlan bridges = plan_bridges(map, areas, base, request.mark, paths, warnings);
    const Terrain terrain = with_mounds(base, box, bridges.mounds, bridges.cuttings);
    std::vector<Volume> volumes = volumes_of(areas, geometry, terrain, request.mark, warnings);
    Site site{map,      request.mark,     geometry,         terrain,           box,
              warnings, std::move(areas), std::move(paths), std::move(volumes)};
    const std::vector<Deck> decks = decks_of(bridges, site);
    trim_stairs(decks, site.paths);
    ModelBuilder model;
    ImportedMap imported;
    try {
        imported.draft = build(site, decks, model);
    } catch (const TooManyTriangles&) {
        const auto [object, triangles] = model.largest();
        throw InputError(request.mark, "bad-size",
                         "it makes more than " + std::to_string(kMaxMapTriangles / 1'000'000) +
                             " million triangles, of which " + object + " has " + std::to_string(triangles) +
                             "; correct a height, level or width of it that can't be, leave it out of the "
                             "file, or choose a part of the map, such as " +
                             smaller_part(map));
    }
    if (geometry.failures() > 0) {
        site.warn("lost-geometry",
                  std::to_string(geometry.failures()) + " pieces of the map couldn't be cut or triangulated");
    }
    imported.model = model.finish();
    imported.model.file = request.mark.file;
    keep_existing(imported.model, imported.draft.solids);
    imported.draft.layers = layers_of(imported.draft);
    imported.draft.latitude_deg = 0.5 * (map.geographic.south + map.geographic.north);
    const double longitude = 0.5 * (map.geographic.west + map.geographic.east);
    imported.draft.longitude_deg = longitude > 180.0 ? longitude - 360.0 : longitude;
    imported.model.geographic =
        GeographicPlace{imported.draft.latitude_deg, imported.draft.longitude_deg, 0.0};
    imported.warnings = warnings.all();
    return imported;
}

/// Says which element costs most of what a map may.
std::string cost_message(const OverlaysTooCostly& cost, const Map& map) {
    constexpr std::uint64_t kSecond = 1'000'000;
    const std::string name = cost.costliest.empty() ? "something" : cost.costliest;
    const std::string why = cost.one_operation ? "too many lines cross in " + name
                                               : "it may cost " + std::to_string(cost.allowed / kSecond) +
                                                     " s, and " + name + " alone costs " +
                                                     std::to_string(cost.its_cost / kSecond) + " s of them";
    return "its paths and areas overlap more than can be worked out: " + why +
           "; leave that out of the file or split it, or choose a smaller part of the map, such as " +
           smaller_part(map);
}

}  // namespace

ImportedMap import_map(const MapRequest& request) {
    DiagnosticList warnings;
    const Map map = read_map(request.file, request.mark, request.section, warnings);
    try {
        return imported_map(request, map, warnings);
    } catch (const OverlaysTooCostly& cost) {
        throw InputError(request.mark, "bad-size", cost_message(cost, map));
    }
}

}  // namespace campuswalk::scene::osm
