#include "engine/walkspace/barrier/ability_meter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::engine {

using collision::MoverSettings;
using collision::Vec3;

namespace {

constexpr double kDegree = 0.017453292519943295;
/// The skin of a body that an opening's width is measured with, metres.
constexpr double kThinSkin = 0.002;
/// How far around the way that was found the exact number is looked for, metres.
constexpr double kAround = 1.5;

}  // namespace

std::vector<Ability> abilities_of(const MoverSettings& body) {
    const double slope = collision::angle_of(std::sqrt(1.0 - body.min_up * body.min_up), body.min_up);
    std::vector<Ability> all{
        {ReasonKind::riser,
         body.step_height,
         {0.35, 0.4, 0.5, 0.6, 0.8, 1.1, 1.5, 2.2, kHighestLedge},
         0.0005,
         [](double value, MoverSettings& b) { b.step_height = value; }},
        {ReasonKind::slope,
         slope,
         {},
         0.05 * kDegree,
         [](double value, MoverSettings& b) { b.min_up = collision::sin_cos(value).cos; }},
        {ReasonKind::opening,
         2.0 * body.radius,
         {},
         0.0005,
         [](double value, MoverSettings& b) {
             b.radius = 0.5 * value;
             b.skin = std::min(b.skin, kThinSkin);  // or the opening would seem narrower by the skin
         }},
        {ReasonKind::headroom,
         body.height,
         {},
         0.0005,
         [](double value, MoverSettings& b) {
             b.height = value;
             b.radius = std::min(b.radius, 0.5 * value);
         }},
    };
    for (const double degrees : {50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 80.0}) {
        all[1].easier.push_back(degrees * kDegree);
    }
    for (const double share : {0.93, 0.8, 0.65, 0.5, 0.33, 0.2}) {
        all[2].easier.push_back(share * all[2].have);
    }
    for (const double share : {0.95, 0.85, 0.7, 0.55, 0.4, 0.3}) {
        all[3].easier.push_back(share * body.height);
    }
    for (Ability& ability : all) {
        const bool grows = ability.easier.back() > ability.easier.front();
        std::erase_if(ability.easier,
                      [&](double v) { return grows ? v <= ability.have : v >= ability.have; });
    }
    std::erase_if(all, [](const Ability& ability) { return ability.easier.empty(); });
    return all;
}

std::vector<Ability> climbs_of(const MoverSettings& body) {
    std::vector<Ability> abilities = abilities_of(body);
    for (Ability& ability : abilities) {
        if (ability.kind == ReasonKind::riser) {
            std::erase_if(ability.easier, [](double height) { return height > kHighestRiser; });
        }
    }
    std::erase_if(abilities,
                  [](const Ability& ability) { return is_about_size(ability) || ability.easier.empty(); });
    return abilities;
}

std::vector<Ability> sizes_of(const MoverSettings& body) {
    std::vector<Ability> abilities = abilities_of(body);
    std::erase_if(abilities, [](const Ability& ability) { return !is_about_size(ability); });
    return abilities;
}

bool is_about_size(const Ability& ability) {
    return ability.kind == ReasonKind::opening || ability.kind == ReasonKind::headroom;
}

MoverSettings easiest_of(MoverSettings body, const std::vector<Ability>& abilities) {
    for (const Ability& ability : abilities) {
        ability.apply(ability.easier.back(), body);
    }
    return body;
}

std::optional<Barrier> AbilityMeter::measure(const Ability& ability) {
    const auto with = [&](double value) {
        MoverSettings changed = probe_.body();
        ability.apply(value, changed);
        return changed;
    };
    if (probe_.is_exhausted()) {
        return std::nullopt;
    }
    const std::optional<double>& likely_riser = probe_.query().likely_riser;
    const bool is_guessed = ability.kind == ReasonKind::riser && likely_riser;
    const double likely = likely_riser.value_or(0.0) - collision::kHeightSlack;
    double fails = ability.have;
    double passes = ability.easier.back();
    std::optional<FoundPath> path;
    if (is_guessed && likely + ability.precision > fails && likely + ability.precision < passes) {
        path = probe_.find_path(with(likely + ability.precision));
        (path ? passes : fails) = likely + ability.precision;
    }
    if (!path) {
        path = probe_.find_path(with(ability.easier.back()));
    }
    if (!path) {
        return std::nullopt;
    }
    const auto probe = [&](double value, std::span<const GroundState> from) {
        if (value <= std::min(fails, passes) || value >= std::max(fails, passes)) {
            return;
        }
        if (auto harder = probe_.find_path(with(value), from)) {
            passes = value;
            path = std::move(harder);
        } else {
            fails = value;
        }
    };
    const std::vector<GroundState>& from = probe_.query().from;
    if (is_guessed) {
        probe(likely - ability.precision, from);
    }
    for (std::span<const double> steps = ability.easier; !steps.empty();) {
        const double middle = steps[steps.size() / 2];
        probe(middle, from);
        const bool too_little = std::abs(middle - ability.have) <= std::abs(fails - ability.have);
        steps = too_little ? steps.subspan(steps.size() / 2 + 1) : steps.first(steps.size() / 2);
    }
    const std::vector<GroundState> near = starts_near(path->start.foot);
    while (std::abs(passes - fails) > ability.precision) {
        probe(0.5 * (passes + fails), near);
    }
    return barrier_of(ability, passes, *path);
}

std::vector<Barrier> AbilityMeter::measure_each(const std::vector<Ability>& abilities) {
    std::vector<Barrier> found;
    if (probe_.find_path(easiest_of(probe_.body(), abilities))) {
        for (const Ability& ability : abilities) {
            if (auto barrier = measure(ability)) {
                found.push_back(std::move(*barrier));
            }
        }
    }
    return found;
}

/// There is a way with every ability at its easiest; then each is made as hard as the others allow.
std::optional<Barrier> AbilityMeter::measure_together(const std::vector<Ability>& abilities) {
    std::optional<FoundPath> path = probe_.find_path(easiest_of(probe_.body(), abilities));
    if (!path) {
        return std::nullopt;
    }
    std::vector<double> values;
    for (const Ability& ability : abilities) {
        values.push_back(ability.easier.back());
    }
    for (std::size_t i = 0; i < abilities.size(); ++i) {
        harden(abilities, i, values);
    }
    if (auto exact = probe_.find_path(body_with(abilities, values))) {
        path = std::move(exact);
    }
    Barrier barrier;
    barrier.kind = ReasonKind::several;
    for (std::size_t i = 0; i < abilities.size(); ++i) {
        if (values[i] != abilities[i].have) {
            barrier.parts.push_back(barrier_of(abilities[i], values[i], *path));
        }
    }
    probe_.locate(*path, barrier);
    return barrier;
}

/// The starts near the one that led to a way.
std::vector<GroundState> AbilityMeter::starts_near(const Vec3& place) const {
    std::vector<GroundState> near = probe_.query().from;
    std::erase_if(
        near, [&](const GroundState& at) { return collision::horizontal_norm(at.foot - place) > kAround; });
    return near;
}

void AbilityMeter::harden(const std::vector<Ability>& abilities, std::size_t which,
                          std::vector<double>& values) {
    const auto passes_with = [&](double value) {
        std::vector<double> tried = values;
        tried[which] = value;
        return probe_.find_path(body_with(abilities, tried)).has_value();
    };
    const Ability& ability = abilities[which];
    double fails = ability.have;
    double passes = values[which];
    if (passes_with(fails)) {
        values[which] = fails;
        return;
    }
    while (std::abs(passes - fails) > ability.precision) {
        const double middle = 0.5 * (passes + fails);
        (passes_with(middle) ? passes : fails) = middle;
    }
    values[which] = passes;
}

MoverSettings AbilityMeter::body_with(const std::vector<Ability>& abilities,
                                      const std::vector<double>& values) const {
    MoverSettings body = probe_.body();
    for (std::size_t i = 0; i < abilities.size(); ++i) {
        abilities[i].apply(values[i], body);
    }
    return body;
}

Barrier AbilityMeter::barrier_of(const Ability& ability, double needed, const FoundPath& path) const {
    Barrier barrier;
    barrier.kind = ability.kind;
    barrier.measured = needed;
    barrier.allowed = ability.have;
    if (ability.kind == ReasonKind::riser) {
        barrier.measured += collision::kHeightSlack;
        barrier.kind = barrier.measured > kHighestRiser ? ReasonKind::ledge : ReasonKind::riser;
    }
    probe_.locate(path, barrier);
    return barrier;
}

}  // namespace campuswalk::engine
