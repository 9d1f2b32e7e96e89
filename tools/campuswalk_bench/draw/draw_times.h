#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

/// One image of one view.
struct TimedImage {
    std::size_t view = 0;
    double ms = 0.0;  ///< wall clock, until the pixels are there
};

/// Our renderer in one process.
inline constexpr const char* kOurs = "campuswalk";
/// Our renderer in several processes at the same time.
inline constexpr const char* kOurProcesses = "processes";

/// The times of one engine for all views, each drawn several times.
struct DrawTimes {
    std::string engine;
    std::string look;  ///< "no-aa", "fxaa", "msaa4", "shadows+fxaa", "shadows+msaa4", "default"
    std::vector<TimedImage> images;
    std::optional<double> cpu_ms;  ///< per image, of all threads; where it is known
};

double mean_ms(const DrawTimes& times);
double median_ms(const DrawTimes& times);
/// The mean over the views of each view's least time, which excludes what else the machine did.
double least_ms(const DrawTimes& times);

}  // namespace campuswalk::tools::bench
