#pragma once

#include <optional>
#include <vector>

#include "collision/mover/mover_settings.h"
#include "engine/walkspace/barrier/passage_probe.h"

namespace campuswalk::engine {

/// One ability of a body, and how it could be better.
struct Ability {
    ReasonKind kind;             ///< of what it overcomes
    double have;                 ///< metres or radians, as Barrier::allowed
    std::vector<double> easier;  ///< values that make it easier, step by step
    double precision;            ///< that the value which is needed is measured with
    void (*apply)(double value, collision::MoverSettings& body);
};

/// Step, slope, width and height, without those that can't be better.
std::vector<Ability> abilities_of(const collision::MoverSettings& body);
/// These are steps up to kHighestRiser, and slopes.
std::vector<Ability> climbs_of(const collision::MoverSettings& body);
/// These are width and height.
std::vector<Ability> sizes_of(const collision::MoverSettings& body);
bool is_about_size(const Ability& ability);

/// The body with these abilities as good as can be.
collision::MoverSettings easiest_of(collision::MoverSettings body, const std::vector<Ability>& abilities);

/// Measures how much better a body's abilities would have to be for it to get through.
class AbilityMeter {
public:
    /// `probe` must outlive it.
    explicit AbilityMeter(PassageProbe& probe) : probe_(probe) {}

    /// Measures one ability alone. None if that doesn't help.
    std::optional<Barrier> measure(const Ability& ability);
    /// Measures each by itself, unless they don't even help together. Returns those that help.
    std::vector<Barrier> measure_each(const std::vector<Ability>& abilities);
    /// Measures how much all of them take at once. None if that doesn't help.
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
