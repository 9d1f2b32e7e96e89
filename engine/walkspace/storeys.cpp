#include "engine/walkspace/storeys.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace campuswalk::engine {

namespace {

/// Heights are counted in bands of this, metres.
constexpr double kBand = 0.25;
/// Ground closer above other ground than this is the same storey: stairs, furniture.
constexpr double kLeastHeight = 1.8;
/// Storeys overlap by at most this share of the lower one's cells.
constexpr double kOverlap = 0.02;

int band_of(float y) {
    return static_cast<int>(std::floor(static_cast<double>(y) / kBand));
}

/// How many nodes each band has, and how many of them have others below them, by the band of those.
struct Bands {
    std::map<int, std::size_t> nodes;
    std::map<int, std::map<int, std::size_t>> above;  ///< above[band][lower band]
};

Bands count_bands(const WalkSpace& space) {
    Bands bands;
    std::vector<float> heights;
    for (const WalkTile& tile : space.tiles) {
        for (const std::uint16_t newest : tile.newest) {
            heights.clear();
            for (std::uint16_t i = newest; i != WalkNode::kNone; i = tile.nodes[i].next) {
                heights.push_back(tile.nodes[i].y);
            }
            std::ranges::sort(heights);
            for (std::size_t i = 0; i < heights.size(); ++i) {
                ++bands.nodes[band_of(heights[i])];
                for (std::size_t k = 0; k < i; ++k) {
                    if (heights[i] - heights[k] >= kLeastHeight) {
                        ++bands.above[band_of(heights[i])][band_of(heights[k])];
                    }
                }
            }
        }
    }
    return bands;
}

/// The first band of the next storey, if the one that begins with `first` ends before the last band.
std::optional<int> next_storey(const Bands& bands, int first) {
    std::size_t own = 0;
    std::size_t overlapping = 0;
    for (auto at = bands.nodes.lower_bound(first); at != bands.nodes.end(); ++at) {
        const auto [band, count] = *at;
        if (const auto lower = bands.above.find(band); lower != bands.above.end()) {
            for (auto below = lower->second.lower_bound(first); below != lower->second.end(); ++below) {
                overlapping += below->second;
            }
        }
        if (own > 0 && static_cast<double>(overlapping) > kOverlap * static_cast<double>(own)) {
            // Cut where there is least ground, up to a storey's height below.
            int cut = band;
            std::size_t least = count;
            const int lowest = std::max(first + 1, band - static_cast<int>(kLeastHeight / kBand));
            for (int candidate = band; candidate >= lowest; --candidate) {
                const auto found = bands.nodes.find(candidate);
                const std::size_t ground = found == bands.nodes.end() ? 0 : found->second;
                if (ground < least) {
                    least = ground;
                    cut = candidate;
                }
            }
            return cut;
        }
        own += count;
    }
    return std::nullopt;
}

}  // namespace

std::vector<Storey> find_storeys(const WalkSpace& space) {
    const Bands bands = count_bands(space);
    std::vector<Storey> storeys;
    if (bands.nodes.empty()) {
        return storeys;
    }
    std::vector<int> firsts{bands.nodes.begin()->first};
    while (const auto next = next_storey(bands, firsts.back())) {
        firsts.push_back(*next);
    }
    storeys.resize(firsts.size(), {1e300, -1e300, 0.0});
    const double cell = space.grid.cell * space.grid.cell;
    for (const WalkTile& tile : space.tiles) {
        for (const WalkNode& node : tile.nodes) {
            const auto after = std::ranges::upper_bound(firsts, band_of(node.y));
            Storey& storey = storeys[static_cast<std::size_t>(after - firsts.begin()) - 1];
            storey.low = std::min(storey.low, static_cast<double>(node.y));
            storey.high = std::max(storey.high, static_cast<double>(node.y));
            storey.area += cell;
        }
    }
    std::erase_if(storeys, [](const Storey& storey) { return storey.area <= 0.0; });
    return storeys;
}

std::size_t storey_at(const std::vector<Storey>& storeys, double y) {
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < storeys.size(); ++i) {
        const double apart = std::max({storeys[i].low - y, y - storeys[i].high, 0.0});
        if (apart < least) {
            least = apart;
            nearest = i;
        }
    }
    return nearest;
}

}  // namespace campuswalk::engine
