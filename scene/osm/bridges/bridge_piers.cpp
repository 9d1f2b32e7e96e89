#include "scene/osm/bridges/bridge_piers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kPierConcrete = {{164, 162, 156}, 235, 255};
constexpr double kInGround = 0.3;  // metres
constexpr double kInDeck = 0.1;

class PierBuilder {
public:
    PierBuilder(const std::vector<Deck>& decks, const Site& site, ModelBuilder& model)
        : decks_(decks), site_(site), model_(model) {}

    void add_nodes() {
        constexpr double kUsualWidth = 1.0;
        constexpr int kSides = 12;
        for (const MapNode& node : site_.map.nodes) {
            if (!affirmed(node.tags, "bridge:support") || !site_.map.box.contains(node.at)) {
                continue;
            }
            const ElementId id{ElementKind::node, node.id};
            const std::optional<double> top = underside({node.at});
            if (!top) {
                warn(id);
                continue;
            }
            const double radius =
                0.5 * std::clamp(length_of(node.tags, "width").value_or(kUsualWidth), 0.2, 10.0);
            object(id).cylinder(kPierConcrete, node.at, radius, radius, kSides,
                                site_.terrain.height(node.at) - kInGround, *top);
            built_.add_obstacle(node.at, radius);
        }
    }

    void add_areas() {
        for (const MapArea& area : site_.areas) {
            if (!affirmed(area.tags, "bridge:support") || affirmed(area.tags, "building") ||
                affirmed(area.tags, "building:part")) {
                continue;
            }
            for (const Polygon& polygon : area.polygons) {
                const std::optional<double> top = underside(polygon.outer);
                if (!top) {
                    warn(area.id);
                    continue;
                }
                object(area.id).walls(kPierConcrete, {polygon}, site_.terrain.lowest({polygon}) - kInGround,
                                      *top);
                built_.obstacles.push_back({polygon});
            }
        }
    }

    Built built() {
        built_.solids.push_back({"bridge-pier", {"bridge-pier/*"}, "", "bridge", true});
        return std::move(built_);
    }

private:
    /// The lowest of the decks' undersides above some points, and a little more; none if no deck is.
    std::optional<double> underside(const std::vector<Point>& points) const {
        std::optional<double> lowest;
        for (const Point& p : points) {
            for (const Deck& deck : decks_) {
                for (const DeckPart& part : deck.parts) {
                    if (!contains(part.area, p)) {
                        continue;
                    }
                    const double height = part.height(p) - deck.bridge->thickness + kInDeck;
                    if (height > site_.terrain.height(p)) {
                        lowest = std::min(lowest.value_or(height), height);
                    }
                }
            }
        }
        return lowest;
    }

    ObjectMesh& object(const ElementId& id) { return model_.object("bridge-pier/" + id.text()); }

    void warn(const ElementId& id) const {
        site_.warn("pier-without-bridge", id.text() + " supports a bridge that isn't there; left out");
    }

    const std::vector<Deck>& decks_;
    const Site& site_;
    ModelBuilder& model_;
    Built built_;
};

}  // namespace

Built add_piers(const std::vector<Deck>& decks, const Site& site, ModelBuilder& model) {
    PierBuilder builder(decks, site, model);
    builder.add_nodes();
    builder.add_areas();
    return builder.built();
}

}  // namespace campuswalk::scene::osm
