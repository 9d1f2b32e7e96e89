#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

/// One image of one view.
struct SequenceImage {
    std::size_t view = 0;
    double ms = 0.0;  ///< wall clock, until the pixels are there
};

/// Ours, an image after the other.
inline constexpr const char* kOurs = "campuswalk";
/// Ours by several processes at the same time.
inline constexpr const char* kOurProcesses = "processes";

/// What one engine took for all views, several times each.
struct DrawTimes {
    std::string engine;
    std::string look;  ///< "no-aa", "fxaa", "msaa4", "shadows+fxaa", "shadows+msaa4", "default"
    std::vector<SequenceImage> frames;
    std::optional<double> cpu_ms;  ///< a frame, of all threads; where it is known
};

double mean_ms(const DrawTimes& times);
double median_ms(const DrawTimes& times);
/// The mean over the views of each one's least: what is left when the machine has nothing else to do.
double least_ms(const DrawTimes& times);

}  // namespace campuswalk::tools::bench
