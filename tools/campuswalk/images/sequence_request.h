#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/script/walk.h"

namespace campuswalk::tools {

/// What to make of a walk besides its snapshots: frames at a fixed interval, and what is put together from
/// them.
struct SequenceRequest {
    std::optional<double> every;          ///< simulated seconds; frames are saved as files
    bool contact_sheet = false;           ///< all frames on one image
    std::vector<std::string> animations;  ///< names of kAnimationKinds
    bool video = false;                   ///< with ffmpeg
    std::optional<engine::View> view;     ///< the walk's settings of this view; nullopt: of its camera
    std::optional<int> width;             ///< pixels, the height in proportion; nullopt: as in the walk

    bool any() const { return every || contact_sheet || !animations.empty() || video; }
};

/// Between two frames, simulated seconds.
inline double interval_of(const SequenceRequest& request) {
    return request.every.value_or(0.5);
}

struct AnimationKind {
    const char* name = "";  ///< as `run --animation` takes it
    const char* file = "";  ///< in the walk's folder
    const char* media_type = "";
};

inline constexpr std::array<AnimationKind, 2> kAnimationKinds = {
    {{"apng", "animation.png", "image/apng"}, {"gif", "animation.gif", "image/gif"}}};

}  // namespace campuswalk::tools
