#include "tools/campuswalk_bench/procedural/table1_scene.h"

#include "tools/campuswalk_bench/procedural/cylinder.h"
#include "tools/campuswalk_bench/procedural/teapot.h"

namespace campuswalk::tools::bench {

namespace {

// The rotation of all ten placements.
collision::Mat3 teapot_rotation() {
    collision::Mat3 R;
    R << -0.087164686690769821, -0.38544175251131685, 0.91860599432787549, -0.19090356479694959,
        0.9114886404318574, 0.36434089437160483, -0.97773112170060172, -0.14360749905450207,
        -0.15303182634143259;
    return R;
}

struct Shift {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    std::uint32_t pairs = 0;
};

constexpr Shift kShifts[] = {
    {-0.43848190287684757, -2.4373767121740486, 2.3850775899535002, 31},
    {-0.41041063177333909, -2.2800624949782637, 2.2093775876577948, 142},
    {-0.36557046977378738, -2.0287737322471022, 1.9287199524117602, 238},
    {0.28342993096272273, 1.6082895708412308, -2.1334178638222405, 347},
    {-0.29768231676293389, -1.6483217175025597, 1.503803367912409, 429},
    {0.12654476778883811, 0.72908938986873661, -1.1514629167814392, 666},
    {-0.075352479386092838, -0.32685663007189536, 0.048747248910726626, 815},
    {0.1143928622716614, 0.66098889321424548, -1.0754033105244822, 961},
    {0.013465561889639099, 0.095382184678085374, -0.44369244700735733, 1081},
    {0.078288036608925179, 0.45865383096571988, -0.84942074178230886, 1295},
};

}  // namespace

Table1Scene table1_scene() {
    Table1Scene scene;
    scene.cylinder = cylinder();
    scene.teapot = teapot();
    for (const Shift& shift : kShifts) {
        scene.placements.push_back({{teapot_rotation(), {shift.x, shift.y, shift.z}}, shift.pairs});
    }
    return scene;
}

}  // namespace campuswalk::tools::bench
