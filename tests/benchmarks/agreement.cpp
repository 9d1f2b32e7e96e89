#include "tests/benchmarks/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "tests/support/plain_geometry.h"

namespace campuswalk::bench {

namespace {

constexpr double kSameHit = 1e-3;  ///< metres along the ray: float32 a hundred metres out, seen at a slant
constexpr double kSameSurface = 1e-6;  ///< metres: the peer's own tolerance

support::Corners plain_corners(const collision::TriangleMesh& mesh, std::size_t i) {
    const collision::Triangle t = corners(mesh, i);
    return {t.a, t.b, t.c};
}

double length_of(const collision::Ray& ray) {
    return (ray.to - ray.from).norm();
}

bool is_free(const collision::TriangleMesh& mesh, const support::Line& line) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (support::passes_through(line, plain_corners(mesh, i))) {
            return false;
        }
    }
    return true;
}

/// Nothing is met before the answer, and something at it.
bool is_first(const collision::TriangleMesh& mesh, const collision::Ray& ray,
              std::optional<double> fraction) {
    if (!fraction) {
        return is_free(mesh, {ray.from, ray.to});
    }
    const double margin = kSameHit / length_of(ray);
    return is_free(mesh, {ray.from, ray.at(std::max(*fraction - margin, 0.0))}) &&
           !is_free(mesh, {ray.at(std::max(*fraction - margin, 0.0)), ray.at(*fraction + margin)});
}

bool same_hit(const collision::Ray& ray, std::optional<double> a, std::optional<double> b) {
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) * length_of(ray) <= kSameHit);
}

}  // namespace

void compare_hits(const collision::TriangleMesh& mesh, const collision::Ray& ray, std::optional<double> ours,
                  std::optional<double> peer, Agreement& agreement) {
    if (same_hit(ray, ours, peer)) {
        ++agreement.same;
        return;
    }
    const bool ours_right = is_first(mesh, ray, ours);
    const bool peer_right = is_first(mesh, ray, peer);
    agreement.too_close_to_call += ours_right && peer_right ? 1 : 0;
    agreement.ours_wrong += ours_right ? 0 : 1;
    agreement.peer_wrong += peer_right ? 0 : 1;
}

void compare_sets(const collision::TriangleMesh& mesh, const collision::Segment& segment, double radius,
                  std::span<const std::uint32_t> ours, std::span<const std::uint32_t> peer,
                  Agreement& agreement) {
    std::vector<std::uint32_t> different;
    std::set_symmetric_difference(ours.begin(), ours.end(), peer.begin(), peer.end(),
                                  std::back_inserter(different));
    if (different.empty()) {
        ++agreement.same;
        return;
    }
    std::size_t ours_wrong = 0;
    std::size_t peer_wrong = 0;
    for (const std::uint32_t i : different) {
        const double gap = support::distance({segment.a, segment.b}, plain_corners(mesh, i)) - radius;
        const bool ours_has = std::binary_search(ours.begin(), ours.end(), i);
        if (std::abs(gap) > kSameSurface) {
            ++(ours_has == (gap < 0.0) ? peer_wrong : ours_wrong);
        }
    }
    agreement.too_close_to_call += ours_wrong + peer_wrong == 0 ? 1 : 0;
    agreement.ours_wrong += ours_wrong > 0 ? 1 : 0;
    agreement.peer_wrong += peer_wrong > 0 ? 1 : 0;
}

void print_agreement(const char* peer_name, const Agreement& agreement) {
    std::printf("    answers            %zu the same", agreement.same);
    if (agreement.too_close_to_call > 0) {
        std::printf(", %zu too close to call", agreement.too_close_to_call);
    }
    if (agreement.peer_wrong > 0) {
        std::printf(", %zu wrong by %s", agreement.peer_wrong, peer_name);
    }
    if (agreement.ours_wrong > 0) {
        std::printf(", %zu WRONG by campuswalk", agreement.ours_wrong);
    }
    std::printf("\n");
}

}  // namespace campuswalk::bench
