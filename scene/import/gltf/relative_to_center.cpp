#include "scene/import/gltf/relative_to_center.h"

#include "scene/import/source/tangent_frame.h"

namespace campuswalk::scene::gltf {

CenterFrame center_frame(const Document& document) {
    CenterFrame frame;
    const auto extensions = document.root().object("extensions");
    const auto relative = extensions ? extensions->object("CESIUM_RTC") : std::nullopt;
    if (!relative) {
        return frame;
    }
    const auto numbers = relative->exact_numbers("center", 3);
    if (!numbers) {
        relative->fail("lacks 'center'");
    }
    Eigen::Matrix3d R_center_file;  // y-up to the center's z-up
    R_center_file << 1, 0, 0,       //
        0, 0, -1,                   //
        0, 1, 0;
    const Eigen::Vector3d center((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (const auto earth = tangent_frame(center)) {
        frame.place = earth->place;
        frame.X_file_rtc.topLeftCorner<3, 3>() = earth->R_local_ecef * R_center_file;
    } else {
        frame.X_file_rtc.topRightCorner<3, 1>() = R_center_file.transpose() * center;
    }
    return frame;
}

}  // namespace campuswalk::scene::gltf
