#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// When a contact may open its building's window.
struct PopupTiming {
    bool once = false;  ///< only if it has never been open
    Tick cooldown = 0;  ///< only this many ticks after it closed
    Tick dwell = 0;     ///< only once the contact has lasted this many ticks
};

/// Which buildings' information windows are open. A contact may open its building's window once: when it
/// begins or, with a dwell, later. The window stays open as long as any of the building's objects is touched.
class Popups {
public:
    explicit Popups(std::size_t buildings) : buildings_(buildings) {}

    /// A contact begins; true if this opens the building's window. `contact` is any number that identifies
    /// it.
    bool enter(std::size_t building, std::size_t contact, Tick tick, const PopupTiming& timing = {});
    /// The contact ends; true if this closes the window.
    bool leave(std::size_t building, std::size_t contact, Tick tick);
    /// The buildings whose windows open now that a contact has lasted long enough.
    std::vector<std::size_t> open_due(Tick tick);

    /// Oldest first.
    const std::vector<std::size_t>& open() const { return open_; }
    /// How many times a building's window has opened.
    int visits(std::size_t building) const { return buildings_[building].visits; }

private:
    struct Building {
        int contacts = 0;
        int visits = 0;
        std::optional<Tick> closed;  ///< when it was last closed
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
    std::vector<Dwelling> dwelling_;  ///< in the order in which the contacts began
    std::vector<std::size_t> open_;
};

}  // namespace campuswalk::engine
