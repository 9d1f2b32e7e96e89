// Embree's rtcCollide: two trees of user geometry, whose leaves are passed to a test of the caller, here
// ours. It has no rigid transforms: the moved mesh's vertices are recomputed and its tree is refitted. It
// can't stop at the first pair.

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "collision/geometry/triangle_overlap.h"
#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/embree_device.h"

namespace campuswalk::tools::bench {

namespace {

using collision::Pose;
using collision::Triangle;
using collision::TriangleMesh;
using collision::TrianglePair;
using collision::Vec3;

/// float32 bounds of the value, fast, because a refit needs six per triangle.
float rounded_down(double value) {
    const auto near = static_cast<float>(value);
    return near - std::abs(near) * 0x1p-23F - std::numeric_limits<float>::min();
}

float rounded_up(double value) {
    const auto near = static_cast<float>(value);
    return near + std::abs(near) * 0x1p-23F + std::numeric_limits<float>::min();
}

/// A mesh's triangles as a scene of one user geometry.
class Body {
public:
    Body(RTCDevice device, const TriangleMesh& mesh)
        : mesh_(mesh), triangles_(mesh.triangles.size()), scene_(rtcNewScene(device)) {
        place({});
        geometry_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(triangles_.size()));
        rtcSetGeometryUserData(geometry_, this);
        rtcSetGeometryBoundsFunction(geometry_, bounds, nullptr);
        rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_REFIT);
        // Scenes of better quality are rebuilt on every commit.
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
        rtcCommitGeometry(geometry_);
        rtcAttachGeometry(scene_, geometry_);
        rtcCommitScene(scene_);
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        rtcReleaseGeometry(geometry_);
        rtcReleaseScene(scene_);
    }

    void move(const Pose& X) {
        place(X);
        rtcCommitGeometry(geometry_);
        rtcCommitScene(scene_);
    }

    RTCScene scene() const { return scene_; }
    const Triangle& triangle(unsigned i) const { return triangles_[i]; }

private:
    void place(const Pose& X) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const auto& t = mesh_.triangles[i];
            const auto vertex = [&](std::uint32_t k) { return b_vertex_in_a(X, mesh_.positions[k]); };
            triangles_[i] = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
        }
    }

    static void bounds(const RTCBoundsFunctionArguments* arguments) {
        const Triangle& t =
            static_cast<const Body*>(arguments->geometryUserPtr)->triangles_[arguments->primID];
        const Vec3 low = t.a.cwiseMin(t.b).cwiseMin(t.c);
        const Vec3 high = t.a.cwiseMax(t.b).cwiseMax(t.c);
        RTCBounds& box = *arguments->bounds_o;
        box.lower_x = rounded_down(low.x());
        box.lower_y = rounded_down(low.y());
        box.lower_z = rounded_down(low.z());
        box.upper_x = rounded_up(high.x());
        box.upper_y = rounded_up(high.y());
        box.upper_z = rounded_up(high.z());
    }

    const TriangleMesh& mesh_;
    std::vector<Triangle> triangles_;
    RTCScene scene_ = nullptr;
    RTCGeometry geometry_ = nullptr;
};

class Embree final : public Engine {
public:
    Embree(const TriangleMesh& a, const TriangleMesh& b) : a_(device_.device, a), b_(device_.device, b) {}

    void set_pose(const Pose& X_a_b) override { b_.move(X_a_b); }

    void all_pairs(std::vector<TrianglePair>& out) override {
        out.clear();
        out_ = &out;
        rtcCollide(a_.scene(), b_.scene(), keep_overlapping, this);
    }

    bool stops_at_first() const override { return false; }
    std::optional<TrianglePair> first_pair() override { return std::nullopt; }

private:
    static void keep_overlapping(void* engine, RTCCollision* candidates, unsigned count) {
        auto* self = static_cast<Embree*>(engine);
        for (unsigned i = 0; i < count; ++i) {
            const TrianglePair pair{candidates[i].primID0, candidates[i].primID1};
            if (overlap(self->a_.triangle(pair.a), self->b_.triangle(pair.b))) {
                self->out_->push_back(pair);
            }
        }
    }

    tbb::global_control one_thread_{tbb::global_control::max_allowed_parallelism, 1};
    EmbreeDevice device_;
    Body a_;
    Body b_;
    std::vector<TrianglePair>* out_ = nullptr;
};

}  // namespace

extern "C" Engine* campuswalk_make_engine(const TriangleMesh& a, const TriangleMesh& b) {
    return new Embree(a, b);
}

}  // namespace campuswalk::tools::bench
