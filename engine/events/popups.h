#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// When a contact may open its building's window.
struct PopupTiming {
    bool once = false;  ///< not a window that has been open before
    Tick cooldown = 0;  ///< so many ticks after it closed
    Tick dwell = 0;     ///< when the contact has lasted so long
};

/// Which buildings' information windows are open. A contact asks for its building's window when it begins or,
/// with a dwell, later, and once only; an open window stays as long as any of the building's objects is met.
class Popups {
public:
    explicit Popups(std::size_t buildings) : buildings_(buildings) {}

    /// True when this opens the building's window. `contact` is any number that tells apart what is met.
    bool meet(std::size_t building, std::size_t contact, Tick tick, const PopupTiming& timing = {});
    /// True when this closes it.
    bool leave(std::size_t building, std::size_t contact, Tick tick);
    /// The buildings whose windows open because a contact has now lasted long enough.
    std::vector<std::size_t> open_due(Tick tick);

    /// Oldest first.
    const std::vector<std::size_t>& open() const { return open_; }
    /// How often a building's window has opened.
    int visits(std::size_t building) const { return buildings_[building].visits; }

private:
    struct Building {
        int met = 0;  ///< how many of its objects are
        int visits = 0;
        std::optional<Tick> closed;  ///< last
    };
    struct Dwelling {
        std::size_t building = 0;
        std::size_t contact = 0;
        Tick due = 0;
        PopupTiming timing;
    };

    bool try_open(std::size_t building, Tick tick, const PopupTiming& timing);
    bool is_open(std::size_t building) const;

    std::vector<Building> buildings_;
    std::vector<Dwelling> dwelling_;  ///< in the order in which they began
    std::vector<std::size_t> open_;
};

}  // namespace campuswalk::engine
