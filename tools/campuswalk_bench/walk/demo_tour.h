#pragma once

#include <optional>

namespace campuswalk::tools::bench {

/// The milliseconds of two minutes of the demo campus' tour at 60 Hz, the least of `rounds`: all ticks from
/// the spawn on, with events, with the campus in memory and without observers. Empty, with the reason
/// printed, where the demo's files are missing.
std::optional<double> time_demo_tour(int rounds);

}  // namespace campuswalk::tools::bench
