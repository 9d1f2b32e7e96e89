#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/walkspace/barrier/abilities.h"
#include "engine/walkspace/barrier/passage_probe.h"

namespace campuswalk::engine {

/// Measures how much better a body's abilities would have to be for it to get through.
class AbilityMeter {
public:
    /// `probe` must outlive it.
    explicit AbilityMeter(PassageProbe& probe) : probe_(probe) {}

    /// One ability alone. None if that doesn't help.
    std::optional<Barrier> measure(const Ability& ability);
    /// Each by itself, unless they don't even help together: those that help.
    std::vector<Barrier> measure_each(const std::vector<Ability>& abilities);
    /// All at once. None if that doesn't help.
    std::optional<Barrier> measure_together(const std::vector<Ability>& abilities);

private:
    std::vector<GroundState> starts_near(const collision::Vec3& place) const;
    void harden(const std::vector<Ability>& abilities, std::size_t which, std::vector<double>& values);
    collision::MoverSettings body_with(const std::vector<Ability>& abilities,
                                       const std::vector<double>& values) const;
    Barrier barrier_of(const Ability& ability, double needed, const FoundPath& path) const;

    PassageProbe& probe_;
};

}  // namespace campuswalk::engine
