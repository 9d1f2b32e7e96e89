#include "engine/walkspace/barrier/abilities.h"

#include <algorithm>
#include <cmath>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::engine {

namespace {

constexpr double kDegree = 0.017453292519943295;
/// The skin of a body that an opening's width is measured with, metres.
constexpr double kThinSkin = 0.002;

}  // namespace

std::vector<Ability> abilities_of(const collision::MoverSettings& body) {
    const double slope = collision::angle_of(std::sqrt(1.0 - body.min_up * body.min_up), body.min_up);
    std::vector<Ability> all{
        {ReasonKind::riser,
         body.step_height,
         {0.35, 0.4, 0.5, 0.6, 0.8, 1.1, 1.5, 2.2, kHighestLedge},
         0.0005,
         [](double value, collision::MoverSettings& b) { b.step_height = value; }},
        {ReasonKind::slope,
         slope,
         {},
         0.05 * kDegree,
         [](double value, collision::MoverSettings& b) { b.min_up = collision::sin_cos(value).cos; }},
        {ReasonKind::opening,
         2.0 * body.radius,
         {},
         0.0005,
         [](double value, collision::MoverSettings& b) {
             b.radius = 0.5 * value;
             b.skin = std::min(b.skin, kThinSkin);  // or the opening would seem narrower by the skin
         }},
        {ReasonKind::headroom,
         body.height,
         {},
         0.0005,
         [](double value, collision::MoverSettings& b) {
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

std::vector<Ability> climbs_of(const collision::MoverSettings& body) {
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

std::vector<Ability> sizes_of(const collision::MoverSettings& body) {
    std::vector<Ability> abilities = abilities_of(body);
    std::erase_if(abilities, [](const Ability& ability) { return !is_about_size(ability); });
    return abilities;
}

bool is_about_size(const Ability& ability) {
    return ability.kind == ReasonKind::opening || ability.kind == ReasonKind::headroom;
}

collision::MoverSettings easiest_of(collision::MoverSettings body, const std::vector<Ability>& abilities) {
    for (const Ability& ability : abilities) {
        ability.apply(ability.easier.back(), body);
    }
    return body;
}

}  // namespace campuswalk::engine
