#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/script/walk.h"

namespace campuswalk::tools {

/// What is to be made of a walk besides its snapshots: images at even times, and what is put together from
/// them.
struct SequenceRequest {
    std::optional<double> every;          ///< simulated seconds; frames are kept as files
    bool contact_sheet = false;           ///< all of them on one image
    std::vector<std::string> animations;  ///< names of kAnimationKinds
    bool video = false;                   ///< by ffmpeg
    std::optional<engine::View> view;     ///< of this kind, as the walk has it; its own camera without
    std::optional<int> width;             ///< pixels, the height in proportion; as the walk says without

    bool any() const { return every || contact_sheet || !animations.empty() || video; }
};

/// Between two frames, simulated seconds.
inline double interval_of(const SequenceRequest& desired) {
    return desired.every.value_or(0.5);
}

struct AnimationKind {
    const char* name = "";  ///< as `run --animation` takes it
    const char* file = "";  ///< in the walk's folder
    const char* media_type = "";
};

inline constexpr std::array<AnimationKind, 2> kAnimationKinds = {
    {{"apng", "animation.png", "image/apng"}, {"gif", "animation.gif", "image/gif"}}};

}  // namespace campuswalk::tools
