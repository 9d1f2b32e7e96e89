#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/lint/level_patches.h"
#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// What people build, or are, alike everywhere.
enum class MeasureKind { riser, storey, door, chair, table, car, person, house };

/// What is usual, metres.
struct UsualSize {
    MeasureKind kind;
    const char* one;   ///< "riser"
    const char* name;  ///< of several, as in "risers are 0.17 m high"
    const char* does;  ///< the rest of such a sentence: "are high", "are long"
    double low;
    double high;
    double typical;
};

const UsualSize& usual_size(MeasureKind kind);

/// What a model has of a kind.
struct Measure {
    MeasureKind kind;
    std::size_t count = 0;
    double median = 0.0;  ///< metres, as the model is read
    double weight = 0.0;  ///< how much it tells of the unit: 2 is enough by itself

    bool is_usual(double scale) const {
        const UsualSize& usual = usual_size(kind);
        return median * scale >= usual.low && median * scale <= usual.high;
    }
};

/// Finds the sizes of what is named as a door and has the shape of a leaf, whichever way it lies: thin, a
/// little longer than wide, and small beside the model.
std::vector<Eigen::Vector3d> door_leaves(const Model& model, const std::vector<NodeReport>& nodes);

/// Measures risers and storeys by geometry, doors, furniture, cars and people by their names, houses by what
/// stands apart. +Y is up. `nodes` is report_nodes(model), `patches` its level_patches().
std::vector<Measure> measure_usual(const Model& model, const std::vector<NodeReport>& nodes,
                                   const std::vector<LevelPatch>& patches);

}  // namespace campuswalk::scene
