#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// The path of a walk, read from its recording (engine/observers/recording.h).
struct RecordedPath {
    struct Key {
        Tick tick = 0;
        std::array<std::int64_t, 3> at = {};  ///< foot, millimetres
        bool cut = false;                     ///< the avatar was put there
    };
    std::vector<Key> keys;    ///< ascending by tick, from 0 on; at least one
    std::string campus_file;  ///< as the walk names it

    /// Millimetres; before the first key and after the last where it began and ended.
    Eigen::Vector3d at(Tick tick) const;
};

/// None for text that isn't a recording, such as one of another version, or one that no walk can have left.
std::optional<RecordedPath> read_recorded_path(std::string_view recording);

/// The path seen from above in at most `most` points: x, z, x, z, … in whole decimetres, each minus the one
/// before. Points are left out where they are missed least.
std::vector<std::int64_t> plan_of(const RecordedPath& path, std::size_t most = 24);

/// The first tick at which the paths are more than a millimetre apart along an axis; none if they never are.
/// Where one ends before the other, they part.
std::optional<Tick> parting_tick(const RecordedPath& a, const RecordedPath& b);

}  // namespace campuswalk::engine
