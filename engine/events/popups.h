#pragma once

#include <cstddef>
#include <vector>

namespace campuswalk::engine {

/// Which buildings' information windows are open: one stays open while any of the building's objects is met.
class Popups {
public:
    explicit Popups(std::size_t buildings) : met_(buildings, 0) {}

    /// True when this opens the building's window.
    bool meet(std::size_t building);
    /// True when this closes it.
    bool leave(std::size_t building);

    /// Oldest first.
    const std::vector<std::size_t>& open() const { return open_; }

private:
    std::vector<int> met_;  ///< by building: how many of its objects are met
    std::vector<std::size_t> open_;
};

}  // namespace campuswalk::engine
