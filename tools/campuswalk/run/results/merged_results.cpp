#include "tools/campuswalk/run/results/merged_results.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <tuple>
#include <utility>

namespace campuswalk::tools {

using engine::WalkResult;

namespace {

constexpr std::size_t kBytesOfAllBlocks = std::size_t{32} << 20U;
constexpr std::size_t kLeastBlock = std::size_t{4} << 10U;
constexpr std::size_t kMostBlock = std::size_t{256} << 10U;

/// The next result of a file, and how to get to the one after it.
struct Source {
    ResultBlocks blocks;
    WalkResult next;
};

}  // namespace

bool comes_before(const WalkResult& a, const WalkResult& b) {
    return std::tie(a.file, a.project, a.repetition) < std::tie(b.file, b.project, b.repetition);
}

void for_each_merged(const std::vector<const ResultFile*>& files, const ResultVisitor& visit) {
    const std::size_t block =
        std::clamp(kBytesOfAllBlocks / std::max<std::size_t>(1, files.size()), kLeastBlock, kMostBlock);
    std::vector<Source> sources;
    sources.reserve(files.size());
    const auto later = [&](std::size_t a, std::size_t b) {
        const bool earlier = comes_before(sources[a].next, sources[b].next);
        return !earlier && (comes_before(sources[b].next, sources[a].next) || b < a);
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> waiting(later);
    for (const ResultFile* file : files) {
        Source source{ResultBlocks(*file, block), {}};
        if (std::optional<WalkResult> first = source.blocks.next()) {
            source.next = std::move(*first);
            sources.push_back(std::move(source));
            waiting.push(sources.size() - 1);
        }
    }
    while (!waiting.empty()) {
        const std::size_t index = waiting.top();
        waiting.pop();
        Source& source = sources[index];
        WalkResult result = std::move(source.next);
        if (std::optional<WalkResult> after = source.blocks.next()) {
            source.next = std::move(*after);
            waiting.push(index);
        }
        visit(std::move(result));
    }
}

}  // namespace campuswalk::tools
