#pragma once

#include <vector>

#include "scene/frame/usual_measures.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// How sure a guess is. Only what is sure may be used without asking.
enum class Confidence { none, unsure, sure };

/// What tells of the axis that is up: how much speaks for +Y, as the model is read, and how much for +Z.
struct UpVote {
    enum class Kind { facing, risers, doors } kind;
    double y = 0.0;  ///< of `facing`: the share of the faces' area that faces that axis; of others: how many
    double z = 0.0;
    double weight = 1.0;  ///< 2 is enough by itself
};

/// What a model's geometry and names say of its unit and its upper axis.
struct FrameGuess {
    std::vector<UpVote> votes;  ///< that aren't a draw
    UpAxis up = UpAxis::y;      ///< z: it lies on its back
    Confidence up_confidence = Confidence::none;
    std::vector<Measure> measures;  ///< along that axis
    double scale = 1.0;             ///< by which the sizes of the model, as it is read, become usual ones
    Confidence scale_confidence = Confidence::none;
};

/// Turns the nodes of `model` and back again.
FrameGuess guess_frame(Model& model);

}  // namespace campuswalk::scene
