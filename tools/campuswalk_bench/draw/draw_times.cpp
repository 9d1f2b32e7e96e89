#include "tools/campuswalk_bench/draw/draw_times.h"

#include <algorithm>
#include <map>

namespace campuswalk::tools::bench {

double mean_ms(const DrawTimes& times) {
    double sum = 0.0;
    for (const TimedImage& image : times.images) {
        sum += image.ms;
    }
    return sum / static_cast<double>(times.images.size());
}

double median_ms(const DrawTimes& times) {
    std::vector<double> ms;
    for (const TimedImage& image : times.images) {
        ms.push_back(image.ms);
    }
    std::sort(ms.begin(), ms.end());
    const std::size_t half = ms.size() / 2;
    return ms.size() % 2 == 1 ? ms.at(half) : 0.5 * (ms.at(half - 1) + ms.at(half));
}

double least_ms(const DrawTimes& times) {
    std::map<std::size_t, double> least;
    for (const TimedImage& image : times.images) {
        const auto [entry, is_first] = least.emplace(image.view, image.ms);
        entry->second = std::min(entry->second, image.ms);
    }
    double sum = 0.0;
    for (const auto& [view, ms] : least) {
        sum += ms;
    }
    return sum / static_cast<double>(least.size());
}

}  // namespace campuswalk::tools::bench
