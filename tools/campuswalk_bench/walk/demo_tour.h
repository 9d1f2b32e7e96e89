#pragma once

#include <optional>

namespace campuswalk::tools::bench {

/// What two minutes at 60 Hz of the demo campus' tour take, milliseconds, the least of `rounds`: the frame
/// loop from the spawn on, events and all, with the campus in memory, and nobody who watches. Nothing, and
/// the reason is said, where the demo's files aren't to be had.
std::optional<double> time_demo_tour(int rounds);

}  // namespace campuswalk::tools::bench
