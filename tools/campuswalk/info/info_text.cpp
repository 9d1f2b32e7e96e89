#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "scene/base/ascii.h"
#include "scene/lint/model_report.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/info/model_info.h"
#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/ground_lint.h"
#include "tools/campuswalk/suggest/lint_text.h"

namespace campuswalk::tools {

using engine::fixed;
using scene::NodeReport;

namespace {

/// A line of the list of nodes: one node, or four or more siblings whose names differ only in numbers, with
/// all below them.
struct NodeLine {
    std::string name;  ///< `tree_*` for several
    int depth = 0;     ///< 0 at the root
    std::size_t nodes = 1;
    std::size_t triangles = 0;                       ///< of all of them, with what isn't listed below them
    Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< metres, of the largest
    std::vector<std::size_t> materials;              ///< indices into ModelReport::materials, ascending
};

struct NodeList {
    std::vector<NodeLine> lines;    ///< parents before their children
    std::size_t omitted_nodes = 0;  ///< in no line: those deepest down, and of those the smallest
};

/// The name with a `*` for each number.
std::string without_numbers(const std::string& name) {
    std::string pattern;
    for (const char c : name) {
        if (!scene::is_digit(c)) {
            pattern += c;
        } else if (!pattern.ends_with('*')) {
            pattern += '*';
        }
    }
    return pattern;
}

class NodeLister {
public:
    explicit NodeLister(const std::vector<NodeReport>& nodes) : nodes_(nodes), children_(nodes.size() + 1) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            children_[slot_of(nodes[n].parent)].push_back(n);
        }
    }

    /// All lines.
    std::vector<NodeLine> list() {
        std::vector<Line> open = lines_below(-1);
        while (!open.empty()) {
            const Line line = std::move(open.back());
            open.pop_back();
            add_line(line.name, line.nodes, line.is_closed);
            if (!line.is_closed) {
                std::ranges::move(lines_below(static_cast<int>(line.nodes.front())),
                                  std::back_inserter(open));
            }
        }
        return std::move(lines_);
    }

private:
    /// That of the roots' is the last.
    std::size_t slot_of(int parent) const {
        return parent < 0 ? nodes_.size() : static_cast<std::size_t>(parent);
    }

    /// A node, or with all below them nodes that are called alike.
    struct Line {
        std::string name;
        std::vector<std::size_t> nodes;
        bool is_closed = false;
    };

    /// The last comes first.
    std::vector<Line> lines_below(int parent) const {
        constexpr std::size_t kAlike = 4;
        const std::vector<std::size_t>& children = children_[slot_of(parent)];
        std::map<std::string, std::vector<std::size_t>> alike;
        for (const std::size_t child : children) {
            alike[without_numbers(nodes_[child].name)].push_back(child);
        }
        std::vector<Line> lines;
        for (const std::size_t child : children) {
            const std::string pattern = without_numbers(nodes_[child].name);
            const std::vector<std::size_t>& group = alike[pattern];
            if (group.size() < kAlike) {
                lines.push_back({nodes_[child].name, {child}, false});
            } else if (group.front() == child) {
                lines.push_back({pattern, group, true});
            }
        }
        std::ranges::reverse(lines);
        return lines;
    }

    void add_line(const std::string& name, const std::vector<std::size_t>& group, bool with_descendants) {
        NodeLine line;
        line.name = name;
        line.depth = nodes_[group.front()].depth;
        line.nodes = group.size();
        std::set<std::size_t> materials;
        for (const std::size_t node : group) {
            const scene::Bounds& bounds = nodes_[node].bounds;
            if (!bounds.empty() && (bounds.max - bounds.min).norm() > line.size.norm()) {
                line.size = bounds.max - bounds.min;
            }
            count(node, with_descendants, line, materials);
        }
        line.materials.assign(materials.begin(), materials.end());
        lines_.push_back(std::move(line));
    }

    void count(std::size_t top, bool with_descendants, NodeLine& line,
               std::set<std::size_t>& materials) const {
        std::vector<std::size_t> open = {top};
        while (!open.empty()) {
            const std::size_t node = open.back();
            open.pop_back();
            line.triangles += nodes_[node].triangles;
            materials.insert(nodes_[node].materials.begin(), nodes_[node].materials.end());
            if (with_descendants) {
                open.insert(open.end(), children_[node].begin(), children_[node].end());
            }
        }
    }

    const std::vector<NodeReport>& nodes_;
    std::vector<std::vector<std::size_t>> children_;  ///< by node; at last the roots
    std::vector<NodeLine> lines_;
};

/// No more than `max_lines`.
NodeList list_nodes(const std::vector<NodeReport>& nodes, std::size_t max_lines) {
    const std::vector<NodeLine> all = NodeLister(nodes).list();
    std::vector<std::size_t> order(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        order[i] = i;
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return std::tuple(all[a].depth, -all[a].size.norm()) < std::tuple(all[b].depth, -all[b].size.norm());
    });
    std::vector<bool> is_shown(all.size(), false);
    for (std::size_t i = 0; i < std::min(max_lines, order.size()); ++i) {
        is_shown[order[i]] = true;
    }
    NodeList list;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (is_shown[i]) {
            list.lines.push_back(all[i]);
        } else {
            list.omitted_nodes += all[i].nodes;
        }
    }
    return list;
}

constexpr std::size_t kMaxLines = 50;       // of a list: nobody reads more, and the warnings come below
constexpr std::size_t kMaxNodeLines = 200;  // of the tree

std::string place_text(const scene::GeographicPlace& place) {
    constexpr int kDigits = 8;  // a millimetre
    return "latitude " + fixed(place.latitude_deg, kDigits) + ", longitude " +
           fixed(place.longitude_deg, kDigits) + ", height " + fixed(place.height, 3) + " m, at " +
           fixed(place.at);
}

void print_omitted(std::size_t count, std::size_t shown) {
    if (count > shown) {
        print_line("  and %zu more: see --json", count - shown);
    }
}

/// The first of `parts`, each in a line of its own.
template <typename Part, typename Print>
void print_list(const std::vector<Part>& parts, const Print& print) {
    for (std::size_t i = 0; i < std::min(parts.size(), kMaxLines); ++i) {
        print(parts[i]);
    }
    print_omitted(parts.size(), kMaxLines);
}

void print_extent(const scene::ModelReport& report) {
    if (report.triangles > 0) {
        print_line("size       %s, from %s to %s",
                   size_text(report.bounds.max - report.bounds.min, 3).c_str(),
                   fixed(report.bounds.min).c_str(), fixed(report.bounds.max).c_str());
    }
    if (const Eigen::Vector3d origin = scene::origin_near(report.bounds); !origin.isZero(0.0)) {
        print_line("origin     %s m, with `origin: {at: near}`", fixed(origin).c_str());
    }
    if (report.geographic) {
        print_line("on Earth   %s", place_text(*report.geographic).c_str());
    }
}

void print_frame(const UprightModel& upright) {
    const std::vector<std::string> lines = frame_lines(upright);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        print_line("%-10s %s", i == 0 ? "frame" : "", lines[i].c_str());
    }
}

void print_buildings(const scene::SuggestedBuildings& buildings) {
    print_line("buildings  %zu%s", buildings.list.size(),
               buildings.left_out == 0
                   ? ""
                   : (", and " + std::to_string(buildings.left_out) + " smaller ones without names").c_str());
    print_list(buildings.list, [](const scene::SuggestedBuilding& building) {
        Eigen::Vector3d foot = building.box.center;
        foot.y() -= 0.5 * building.box.size.y();
        print_line("  %-28s %s x %s m, %s m high, at %s", building.title.c_str(),
                   fixed(building.box.size.x(), 1).c_str(), fixed(building.box.size.z(), 1).c_str(),
                   fixed(building.box.size.y(), 1).c_str(), fixed(foot).c_str());
    });
}

void print_doors(const scene::ModelReport& report) {
    const auto closed = std::ranges::count_if(report.doors, &scene::Door::is_closed);
    print_line("doors      %zu%s", report.doors.size(),
               closed > 0 ? (", " + std::to_string(closed) + " closed").c_str() : "");
    print_list(report.doors, [&](const scene::Door& door) {
        print_line("  %-28s %s m wide, %s m high%s, at %s", report.nodes[door.node].name.c_str(),
                   fixed(door.width, 2).c_str(), fixed(door.height, 2).c_str(),
                   door.is_closed ? ", closed" : "", fixed(door.foot).c_str());
    });
}

/// "16 risers of 0.160 m (the first 0.450 m)"
std::string risers_text(const scene::Flight& flight) {
    constexpr double kNoticed = 0.01;  // metres
    const double usual = scene::usual_riser(flight);
    const auto odd =
        std::ranges::max_element(flight.risers, {}, [&](double riser) { return std::abs(riser - usual); });
    std::string text = std::to_string(flight.risers.size()) + " risers of " + fixed(usual, 3) + " m";
    if (std::abs(*odd - usual) > kNoticed) {
        const auto number = odd - flight.risers.begin() + 1;
        text += " (number " + std::to_string(number) + " from below " + fixed(*odd, 3) + " m)";
    }
    return text;
}

void print_flights(const scene::ModelReport& report) {
    print_line("stairs     %zu", report.flights.size());
    print_list(report.flights, [&](const scene::Flight& flight) {
        print_line("  %-28s %s, treads of %s m, %s m wide, from %s", report.nodes[flight.node].name.c_str(),
                   risers_text(flight).c_str(), fixed(flight.tread_depth, 2).c_str(),
                   fixed(flight.width, 2).c_str(), fixed(flight.foot).c_str());
    });
}

void print_materials(const scene::ModelReport& report) {
    print_line("materials  %zu", report.materials.size());
    print_list(report.materials, [](const scene::MaterialReport& material) {
        print_line("  %-28s %8zu triangles  %s", material.name.c_str(), material.triangles,
                   material.texture.empty() ? "no texture" : material.texture.c_str());
    });
}

std::string materials_text(const scene::ModelReport& report, const std::vector<std::size_t>& materials) {
    constexpr std::size_t kMaxNames = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(materials.size(), kMaxNames); ++i) {
        text += (i == 0 ? "  " : ", ") + report.materials[materials[i]].name;
    }
    return materials.size() > kMaxNames ? text + ", …" : text;
}

void print_nodes(const scene::ModelReport& report) {
    const NodeList list = list_nodes(report.nodes, kMaxNodeLines);
    print_line("nodes      %zu", report.nodes.size());
    for (const NodeLine& line : list.lines) {
        const std::string several = line.nodes > 1 ? " (" + std::to_string(line.nodes) + " nodes)" : "";
        const std::string size = line.size.isZero(0.0) ? "" : "  " + size_text(line.size, 1);
        const std::string triangles =
            line.triangles == 0 ? "" : "  " + std::to_string(line.triangles) + " triangles";
        print_line("  %*s%s%s%s%s%s", 2 * line.depth, "", line.name.c_str(), several.c_str(), size.c_str(),
                   triangles.c_str(), materials_text(report, line.materials).c_str());
    }
    print_omitted(list.omitted_nodes, 0);
}

}  // namespace

void print_text(const ModelInfo& info) {
    const scene::ModelReport& report = info.upright.report;
    print_line("%s", report.file.c_str());
    print_extent(report);
    print_frame(info.upright);
    if (info.ground) {
        print_line("ground     %s", ground_text(*info.ground).c_str());
    }
    print_buildings(info.buildings);
    print_doors(report);
    print_flights(report);
    if (info.places) {
        print_line("places     %zu, %zu of them within its bounds", info.places->named,
                   info.places->within_bounds);
    }
    print_line("meshes     %zu, placed %zu times", report.meshes, report.placements);
    print_line("triangles  %zu", report.triangles);
    print_materials(report);
    print_nodes(report);
    print_line("warnings   %zu", report.warnings.size());
    print_lints(report.warnings);
}

}  // namespace campuswalk::tools
