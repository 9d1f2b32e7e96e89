// Embree's tree of a static mesh, built and traversed with the defaults except for the robust flag: no ray
// slips through between two triangles. float32.

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/peers/embree_device.h"

namespace campuswalk::tools::bench {

namespace {

class EmbreeRobust final : public RayEngine {
public:
    explicit EmbreeRobust(const collision::TriangleMesh& mesh) : scene_(rtcNewScene(device_.device)) {
        const RTCGeometry geometry = rtcNewGeometry(device_.device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<Eigen::Vector3f*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(mesh.positions[0]), mesh.positions.size()));
        std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
        auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(mesh.triangles[0]), mesh.triangles.size()));
        std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    EmbreeRobust(const EmbreeRobust&) = delete;
    EmbreeRobust& operator=(const EmbreeRobust&) = delete;
    ~EmbreeRobust() override { rtcReleaseScene(scene_); }

    std::optional<double> first_on_ray(const collision::Ray& ray) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const Eigen::Vector3f from = ray.from.cast<float>();
        const Eigen::Vector3f along = (ray.to - ray.from).cast<float>();
        RTCRayHit query;
        query.ray.org_x = from.x();
        query.ray.org_y = from.y();
        query.ray.org_z = from.z();
        query.ray.dir_x = along.x();
        query.ray.dir_y = along.y();
        query.ray.dir_z = along.z();
        query.ray.tnear = 0.0F;
        query.ray.tfar = 1.0F;
        query.ray.time = 0.0F;
        query.ray.mask = ~0U;
        query.ray.id = 0;
        query.ray.flags = 0;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::nullopt
                                                           : std::optional<double>(query.ray.tfar);
    }

private:
    tbb::global_control one_thread_{tbb::global_control::max_allowed_parallelism, 1};
    EmbreeDevice device_;
    RTCScene scene_ = nullptr;
};

}  // namespace

extern "C" RayEngine* campuswalk_make_ray_engine(const collision::TriangleMesh& mesh) {
    return new EmbreeRobust(mesh);
}

}  // namespace campuswalk::tools::bench
