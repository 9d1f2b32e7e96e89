#include "tests/support/mesh_volume.h"

#include <Eigen/Geometry>

namespace campuswalk::support {

double enclosed_volume(const collision::TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const collision::Triangle t = vertices(mesh, i);
        sum += t.a.dot(t.b.cross(t.c)) / 6.0;
    }
    return sum;
}

}  // namespace campuswalk::support
