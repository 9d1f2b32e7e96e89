#include <cstdio>
#include <exception>
#include <string_view>

#include "engine/render/image/png.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/small_scenes.h"

// draw_one_image FILE.png osmesa|egl
int main(int argc, char** argv) {
    using namespace campuswalk::engine::render;
    if (argc != 3) {
        return 2;
    }
    try {
        const auto model = test::tower_scene();
        const bool egl = std::string_view(argv[2]) == "egl";
        Renderer renderer(std::span(&model, 1), test::quick_settings(),
                          egl ? make_egl_context() : make_osmesa_context());
        write_png(renderer.draw(test::tower_view(), test::kWidth, test::kHeight), argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    return 0;
}
