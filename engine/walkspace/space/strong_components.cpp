#include "engine/walkspace/space/strong_components.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace campuswalk::engine {

namespace {

using Edges = std::vector<std::vector<std::uint32_t>>;

Edges reversed(const Edges& targets) {
    Edges sources(targets.size());
    for (std::uint32_t from = 0; from < targets.size(); ++from) {
        for (const std::uint32_t to : targets[from]) {
            sources[to].push_back(from);
        }
    }
    return sources;
}

/// Appends what one gets to from the vertex and isn't visited yet, each after all that is behind it. Without
/// recursion, as paths may be long.
void visit(const Edges& targets, std::uint32_t first, std::vector<bool>& visited,
           std::vector<std::uint32_t>& finished) {
    std::vector<std::pair<std::uint32_t, std::size_t>> path;  // vertices, and how many edges were followed
    const auto enter = [&](std::uint32_t vertex) {
        if (!visited[vertex]) {
            visited[vertex] = true;
            path.emplace_back(vertex, 0);
        }
    };
    enter(first);
    while (!path.empty()) {
        auto& [vertex, followed] = path.back();
        if (followed < targets[vertex].size()) {
            enter(targets[vertex][followed++]);
        } else {
            finished.push_back(vertex);
            path.pop_back();
        }
    }
}

}  // namespace

std::vector<std::uint32_t> strong_components(const Edges& targets) {
    const auto count = static_cast<std::uint32_t>(targets.size());
    std::vector<std::uint32_t> finished;
    std::vector<bool> visited(count, false);
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
        visit(targets, vertex, visited, finished);
    }
    const Edges sources = reversed(targets);
    std::vector<std::uint32_t> least(count);
    visited.assign(count, false);
    for (std::size_t i = count; i-- > 0;) {
        std::vector<std::uint32_t> component;
        visit(sources, finished[i], visited, component);
        std::ranges::sort(component);
        for (const std::uint32_t vertex : component) {
            least[vertex] = component.front();
        }
    }
    return least;
}

}  // namespace campuswalk::engine
