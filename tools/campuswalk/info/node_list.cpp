#include "tools/campuswalk/info/node_list.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace campuswalk::tools {

namespace {

using scene::NodeReport;

/// The name with a `*` for each number.
std::string without_numbers(const std::string& name) {
    std::string pattern;
    for (const char c : name) {
        const bool is_digit = c >= '0' && c <= '9';
        if (!is_digit) {
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

}  // namespace

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

}  // namespace campuswalk::tools
