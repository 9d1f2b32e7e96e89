#include "scene/frame/guess_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "scene/frame/stair_rhythm.h"
#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

Eigen::Matrix4d upright_from_z() {
    Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
    turn.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    return turn;
}

void turn(Model& model, const Eigen::Matrix4d& by) {
    for (Node& node : model.nodes) {
        node.X_world_node = by * node.X_world_node;
    }
}

/// The share of the faces' area by the axis that they face, within 26 degrees.
Vector3d facing_shares(const Model& model) {
    constexpr double kFacing = 0.9;
    Vector3d areas = Vector3d::Zero();
    double all = 0.0;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
            const Vector3d normal = (b - a).cross(c - a);
            const double length = normal.norm();
            all += length;
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                areas[axis] += std::abs(normal[axis]) > kFacing * length ? length : 0.0;
            }
        });
    }
    return all > 0.0 ? (areas / all).eval() : areas;
}

/// Floors, roofs and ground face up and down, and most places are wider than high. A long house alone may
/// face Z as much as a place on its back does, so that only what is flat tells it by itself.
UpVote vote_by_faces(const Model& model, const Vector3d& size) {
    constexpr double kMore = 1.6;
    constexpr double kMuchMore = 6.0;
    const Vector3d shares = facing_shares(model);
    const auto wins = [&](Eigen::Index axis, Eigen::Index other, double more, double flat) {
        return shares[axis] > more * std::max(shares[other], shares[0]) &&
               size[axis] <= flat * std::max(size[other], size[0]);
    };
    const bool is_flat = wins(1, 2, kMuchMore, 0.3) || wins(2, 1, kMuchMore, 0.3);
    return {UpVote::Kind::facing, wins(1, 2, kMore, 0.8) ? shares[1] : 0.0,
            wins(2, 1, kMore, 0.8) ? shares[2] : 0.0, is_flat ? 2.0 : 1.0};
}

double count_risers(const std::vector<LevelPatch>& patches) {
    std::size_t count = 0;
    for (const StairRhythm& rhythm : stair_rhythms(patches)) {
        count += rhythm.risers;
    }
    return static_cast<double>(count);
}

/// Doors are higher than wide, and thin.
UpVote vote_by_doors(const Model& model, const std::vector<NodeReport>& nodes) {
    UpVote vote{UpVote::Kind::doors, 0.0, 0.0, 2.0};
    for (const Vector3d& size : door_leaves(model, nodes)) {
        vote.y += size.y() == size.maxCoeff() ? 1.0 : 0.0;
        vote.z += size.z() == size.maxCoeff() ? 1.0 : 0.0;
    }
    return vote;
}

void guess_up(const std::vector<UpVote>& votes, FrameGuess& guess) {
    double for_y = 0.0;
    double for_z = 0.0;
    for (const UpVote& vote : votes) {
        if (vote.y != vote.z) {
            (vote.y > vote.z ? for_y : for_z) += vote.weight;
            guess.votes.push_back(vote);
        }
    }
    if (for_z > for_y) {
        guess.up = UpAxis::z;
        guess.up_confidence = for_z >= 2.0 && for_y == 0.0 ? Confidence::sure : Confidence::unsure;
    } else if (for_y > 0.0) {
        guess.up_confidence = for_y >= 2.0 * for_z ? Confidence::sure : Confidence::unsure;
    }
}

double fitting(const std::vector<Measure>& measures, double scale) {
    double weight = 0.0;
    for (const Measure& measure : measures) {
        weight += measure.is_usual(scale) ? measure.weight : 0.0;
    }
    return weight;
}

/// Two digits, so that nobody takes it for exact.
double rounded(double scale) {
    double power = 1.0;
    for (; scale >= 100.0 * power; power *= 10.0) {
    }
    for (; scale < 10.0 * power; power /= 10.0) {
    }
    return std::round(scale / power) * power;
}

void guess_scale(FrameGuess& guess) {
    constexpr std::array<double, 6> kUnits = {0.01, 0.001, 0.0254, 0.3048, 100.0, 1000.0};
    constexpr double kEnough = 2.0;       // weight, to be sure
    constexpr double kLeast = 0.5;        // to say anything
    constexpr double kLeastScale = 1e-9;  // as on the command line
    constexpr double kMostScale = 1e9;
    double all = 0.0;
    for (const Measure& measure : guess.measures) {
        all += measure.weight;
    }
    const double as_it_is = fitting(guess.measures, 1.0);
    if (all < kLeast) {
        return;
    }
    if (2.0 * as_it_is >= all) {
        guess.scale_confidence = as_it_is >= kEnough ? Confidence::sure : Confidence::unsure;
        return;
    }
    const double unit =
        *std::ranges::max_element(kUnits, {}, [&](double each) { return fitting(guess.measures, each); });
    double best = fitting(guess.measures, unit) > as_it_is ? unit : 1.0;
    for (const Measure& measure : guess.measures) {
        const double exact = usual_size(measure.kind).typical / measure.median;
        const double scale = exact > kLeastScale && exact < kMostScale ? rounded(exact) : 1.0;
        best = fitting(guess.measures, scale) > fitting(guess.measures, best) ? scale : best;
    }
    const bool is_sure = best == unit && 4.0 * fitting(guess.measures, best) >= 3.0 * all &&
                         fitting(guess.measures, best) >= kEnough && 4.0 * as_it_is <= all;
    guess.scale = best;
    guess.scale_confidence = is_sure ? Confidence::sure : Confidence::unsure;
}

}  // namespace

FrameGuess guess_frame(Model& model) {
    constexpr double kWeld = 1e-6;  // of the model's size
    FrameGuess guess;
    const Bounds bounds = world_bounds(model);
    if (bounds.empty() || bounds.min == bounds.max) {
        return guess;
    }
    const Vector3d size = bounds.max - bounds.min;
    const double weld = kWeld * size.maxCoeff();
    const std::vector<NodeReport> nodes = report_nodes(model);
    const std::vector<LevelPatch> along_y = level_patches(model, weld);
    turn(model, upright_from_z());
    const std::vector<LevelPatch> along_z = level_patches(model, weld);
    turn(model, upright_from_z().transpose());
    guess_up({vote_by_faces(model, size),
              {UpVote::Kind::risers, count_risers(along_y), count_risers(along_z), 2.0},
              vote_by_doors(model, nodes)},
             guess);
    if (guess.up == UpAxis::z) {
        turn(model, upright_from_z());
        guess.measures = measure_usual(model, report_nodes(model), along_z);
        turn(model, upright_from_z().transpose());
    } else {
        guess.measures = measure_usual(model, nodes, along_y);
    }
    guess_scale(guess);
    return guess;
}

}  // namespace campuswalk::scene
