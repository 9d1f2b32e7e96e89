#include "scene/osm/bridges/decks.h"

#include <algorithm>
#include <cmath>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kAbove = 0.02;  // metres that a deck is above the ground beside its ends
constexpr Look kConcrete = {{170, 168, 162}, 235, 255};
constexpr Look kDeckAsphalt = {{112, 112, 114}, 235, 255};
constexpr Look kParapet = {{120, 126, 126}, 190, 150};
constexpr Look kRail = {{92, 98, 102}, 140, 255};

Polygons area_of_parts(const std::vector<DeckPart>& parts, const PlanGeometry& geometry) {
    std::vector<const Polygons*> all;
    all.reserve(parts.size());
    for (const DeckPart& part : parts) {
        all.push_back(&part.area);
    }
    return geometry.united(all);
}

class DeckBuilder {
public:
    DeckBuilder(const std::vector<Deck>& decks, std::size_t number, const Site& site, ModelBuilder& model)
        : decks_(decks),
          parts_(decks[number].parts),
          bridge_(*decks[number].bridge),
          site_(site),
          mesh_(model.object("bridge/" +
                             ElementId{ElementKind::way, site.paths[bridge_.paths.front()].way->id}.text())) {
        for (const PathAtBridge& stairs : bridge_.stairs) {
            if (!site.paths[stairs.path].leaves_ground) {
                stairs_.push_back(&site.paths[stairs.path]);
            }
        }
    }

    void add_slab() {
        for (const DeckPart& part : parts_) {
            const Look look = part.path->carriageway ? kDeckAsphalt : look_of_deck(part.path->way->tags);
            for (const Polygon& polygon : part.area) {
                const Triangulation flat = site_.geometry.triangulated(polygon);
                for (const auto& [a, b, c] : flat.triangles) {
                    const Point3 pa = top(part, flat.points[a]);
                    const Point3 pb = top(part, flat.points[b]);
                    const Point3 pc = top(part, flat.points[c]);
                    mesh_.triangle(look, pa, pb, pc);
                    mesh_.triangle(kConcrete, under(pa), under(pc), under(pb));
                }
            }
        }
    }

    /// The slab's sides and what keeps people from falling, around all parts.
    void add_edges() {
        constexpr double kPiece = 1.5;  // metres
        for (const Polygon& polygon : area_of_parts(parts_, site_.geometry)) {
            std::vector<const Ring*> rings = {&polygon.outer};
            for (const Ring& hole : polygon.holes) {
                rings.push_back(&hole);
            }
            for (const Ring* ring : rings) {
                for (std::size_t i = 0; i < ring->size(); ++i) {
                    const Point& a = (*ring)[i];
                    const Point& b = (*ring)[(i + 1) % ring->size()];
                    const int pieces = std::clamp(static_cast<int>(norm(b - a) / kPiece), 1, 1000);
                    for (int k = 0; k < pieces; ++k) {
                        add_edge(a + (b - a) * (static_cast<double>(k) / pieces),
                                 a + (b - a) * ((k + 1.0) / pieces));
                    }
                }
            }
        }
    }

private:
    static Look look_of_deck(const Tags& tags) {
        const std::string_view surface = tags.get("surface");
        if (const auto color = material_color(surface)) {
            return {*color, 220, 255};
        }
        return kConcrete;
    }

    static Point3 top(const DeckPart& part, const Point& p) { return {p, part.height(p) + kAbove}; }
    Point3 under(const Point3& p) const { return {p.at, p.height - bridge_.thickness - kAbove}; }

    Point3 top_of_nearest(const Point& p) const {
        const DeckPart* best = &parts_.front();
        double nearest = 1e300;
        for (const DeckPart& part : parts_) {
            const double distance = nearest_on(part.line, false, p).distance - 0.5 * part.width;
            if (distance < nearest) {
                nearest = distance;
                best = &part;
            }
        }
        return top(*best, p);
    }

    void add_edge(const Point& a, const Point& b) {
        const Point3 high_a = top_of_nearest(a);
        const Point3 high_b = top_of_nearest(b);
        mesh_.quad(kConcrete, under(high_a), under(high_b), high_b, high_a);
        const Point out = Point(unit(b - a).y(), -unit(b - a).x());  // rings run around areas on their left
        const Point middle = 0.5 * (a + b);
        constexpr double kFall = 0.45;  // metres that need a parapet
        const double drop = 0.5 * (high_a.height + high_b.height) - site_.terrain.height(middle + 0.3 * out);
        const double height = 0.5 * (high_a.height + high_b.height);
        if (drop < kFall || leads_to_stairs(middle) || leads_to_a_deck(middle + 0.1 * out, height)) {
            return;
        }
        add_parapet(high_a, high_b, -out);
    }

    /// A panel between posts under a handrail, a little inside of the edge.
    void add_parapet(const Point3& a, const Point3& b, const Point& inwards) {
        constexpr double kHeight = 1.1;
        constexpr double kInset = 0.08;
        constexpr double kHalf = 0.03;
        const Point from = a.at + kInset * inwards;
        const Point to = b.at + kInset * inwards;
        const auto bar = [&](const Look& look, double half, double low, double high) {
            const Point side = half * inwards;
            const auto at = [](const Point& p, double height) { return Point3{p, height}; };
            const double al = a.height + low;
            const double bl = b.height + low;
            const double ah = a.height + high;
            const double bh = b.height + high;
            mesh_.quad(look, at(from - side, al), at(to - side, bl), at(to - side, bh), at(from - side, ah));
            mesh_.quad(look, at(to + side, bl), at(from + side, al), at(from + side, ah), at(to + side, bh));
            mesh_.quad(look, at(from - side, ah), at(to - side, bh), at(to + side, bh), at(from + side, ah));
        };
        bar(kParapet, 0.01, 0.0, kHeight - 0.05);
        bar(kRail, kHalf, kHeight - 0.05, kHeight);
        mesh_.box(kRail, from, unit(b.at - a.at), Point(kHalf, kHalf), a.height, a.height + kHeight);
    }

    bool leads_to_stairs(const Point& p) const {
        return std::ranges::any_of(stairs_, [&](const Path* path) {
            return nearest_on(path->way->points, false, p).distance < 0.5 * path->width + 0.1;
        });
    }

    /// Whether another bridge goes on there, as two roads do in one outline.
    bool leads_to_a_deck(const Point& p, double height) const {
        constexpr double kStep = 0.3;  // metres
        const auto is_there = [&](const DeckPart& part) {
            return contains(part.area, p) && std::abs(top(part, p).height - height) < kStep;
        };
        return std::ranges::any_of(decks_, [&](const Deck& deck) {
            return deck.bridge != &bridge_ && std::ranges::any_of(deck.parts, is_there);
        });
    }

    const std::vector<Deck>& decks_;
    const std::vector<DeckPart>& parts_;
    const Bridge& bridge_;
    const Site& site_;
    ObjectMesh& mesh_;
    std::vector<const Path*> stairs_;
};

}  // namespace

void add_deck(const std::vector<Deck>& decks, std::size_t number, const Site& site, ModelBuilder& model) {
    DeckBuilder builder(decks, number, site, model);
    builder.add_slab();
    builder.add_edges();
}

}  // namespace campuswalk::scene::osm
