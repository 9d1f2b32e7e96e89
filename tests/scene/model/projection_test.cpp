#include "scene/model/projection.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

struct Projected {
    double latitude_deg;
    double longitude_deg;
    double east;
    double north;
};

/// By PROJ 9.1: proj -f %.6f +proj=ortho +lat_0=LAT +lon_0=LON +ellps=WGS84, the first being the origin.
const std::vector<std::vector<Projected>> kByProj = {
    {{48.15, 11.57, 0, 0},
     {48.16, 11.58, 743.943122, 1111.981723},
     {48.1, 11.6, 2234.430546, -5559.201232},
     {48.24, 11.450000000000001, -8913.422207, 10014.419116}},
    {{-0.2, -78.5, 0, 0},
     {-0.19, -78.49, 1113.188823, 1105.742542},
     {-0.25, -78.47, 3339.552994, -5528.717001},
     {-0.11000000000000001, -78.62, -13358.304675, 9951.632653}},
    {{71, 179.99, 0, 0},
     {71.01, 180.0, 363.326082, 1115.774612},
     {70.95, 180.02, 1093.292040, -5578.433681},
     {71.09, 179.87, -4342.228464, 10046.040596}}};

TEST(Projection, IsThatOfProj) {
    for (const std::vector<Projected>& points : kByProj) {
        const Projection projection(points[0].latitude_deg, points[0].longitude_deg);
        for (const Projected& point : points) {
            const Eigen::Vector2d p = projection.project(point.latitude_deg, point.longitude_deg);
            EXPECT_NEAR(p.x(), point.east, 1e-5);
            EXPECT_NEAR(p.y(), point.north, 1e-5);
            const GeographicPoint back = projection.unproject({point.east, point.north});
            EXPECT_NEAR(back.latitude_deg, point.latitude_deg, 1e-10);
            const double wrapped = back.longitude_deg < 0.0 && point.longitude_deg > 0.0
                                       ? back.longitude_deg + 360.0
                                       : back.longitude_deg;
            EXPECT_NEAR(wrapped, point.longitude_deg, 1e-10);
        }
    }
}

TEST(Projection, StaysFiniteWhereThereIsNoEarth) {
    const Projection projection(48.15, 11.57);
    for (const double far : {6.3e6, 6.5e6, 1e7, 1e12}) {
        const GeographicPoint point = projection.unproject({far, -far});
        EXPECT_TRUE(std::isfinite(point.latitude_deg) && std::isfinite(point.longitude_deg)) << far;
    }
}

TEST(MapFrame, GoesThereAndBack) {
    const MapFrame frame({48.15, 11.57, 500.0, {10, 2, -30}});
    const Eigen::Vector3d p = frame.to_world({11.58, 48.16, 512.5});
    EXPECT_LT((p - Eigen::Vector3d(753.943122, 14.5, -1141.981723)).norm(), 1e-5);
    EXPECT_LT((frame.to_map(p) - Eigen::Vector3d(11.58, 48.16, 512.5)).norm(), 1e-9);
    EXPECT_LT((frame.to_map({10, 2, -30}) - Eigen::Vector3d(11.57, 48.15, 500.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace campuswalk::scene
