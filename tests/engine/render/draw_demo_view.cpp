#include <cstdio>
#include <exception>

#include "engine/render/image/png.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/campus_view.h"

// draw_demo_view VIEW FILE.png [VIEW FILE.png …]
int main(int argc, char** argv) {
    using namespace campuswalk::engine::render;
    if (argc < 3 || argc % 2 == 0) {
        return 2;
    }
    try {
        const auto models = test::demo_models();
        Renderer renderer(models);
        for (int i = 1; i < argc; i += 2) {
            write_png(renderer.draw(test::demo_view(argv[i]), 1280, 720), argv[i + 1]);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    return 0;
}
