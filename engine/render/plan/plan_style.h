#pragma once

#include <array>
#include <cstdint>

#include "engine/render/overlay/canvas.h"
#include "engine/render/plan/storey_plan.h"

// The colours of plans: told apart by brightness or by blue against orange, which colour-blind people see,
// too.
namespace campuswalk::engine::render {

using PlanColor = std::array<std::uint8_t, 3>;  ///< sRGB

constexpr PlanColor kPaper = {255, 255, 255};
constexpr PlanColor kNoReturnStripe = {44, 98, 166};

/// Of the area of cells of a kind; for no_return, between the stripes.
constexpr PlanColor color_of(PlanCell cell) {
    switch (cell) {
        case PlanCell::reached:
        case PlanCell::no_return:
            return {166, 206, 240};
        case PlanCell::unreached:
            return {245, 166, 66};
        case PlanCell::solid:
            return {112, 114, 120};
        default:
            return kPaper;
    }
}

/// Whether no_return cells have a stripe at this pixel. Stripes go by pixels, not cells, to look the same at
/// any scale.
constexpr bool is_on_stripe(int x, int y) {
    return (x + y) % 8 < 3;
}

/// For a passage as narrow as 0 to one as wide as 1: purple, blue, then nearly white.
PlanColor width_color(double share);

constexpr Rgba kInk = {0.13, 0.14, 0.16, 1.0};
constexpr Rgba kFaintInk = {0.36, 0.38, 0.42, 1.0};
constexpr Rgba kHalo = {1.0, 1.0, 1.0, 0.85};  ///< around text on the plan

constexpr Rgba rgba_of(const PlanColor& color) {
    return {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, 1.0};
}

}  // namespace campuswalk::engine::render
