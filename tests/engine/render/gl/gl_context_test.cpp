#include "engine/render/gl/gl_context.h"

#include <memory>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

class EachBackend : public testing::TestWithParam<RenderingBackend> {};

INSTANTIATE_TEST_SUITE_P(Backends, EachBackend,
                         testing::Values(RenderingBackend::osmesa, RenderingBackend::egl),
                         [](const auto& tested) {
                             return tested.param == RenderingBackend::egl ? "Egl" : "OsMesa";
                         });

TEST_P(EachBackend, ProvidesOpenGl33) {
    const auto context = make_gl_context(GetParam());
    EXPECT_EQ(context->backend(), GetParam() == RenderingBackend::egl ? "EGL" : "OSMesa");
    const GlFunctions gl = load_gl_functions(*context);
    GLint major = 0;
    GLint minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 33);
}

TEST_P(EachBackend, SupportsSeveralContextsAtOnce) {
    const auto first = make_gl_context(GetParam());
    const auto second = make_gl_context(GetParam());
    for (GlContext* context : {first.get(), second.get(), first.get()}) {
        EXPECT_NO_THROW(context->make_current());
        EXPECT_EQ(load_gl_functions(*context).GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST(OsMesaContext, ReturnsNullForUnknownFunctions) {
    EXPECT_EQ(make_osmesa_context()->procedure("noSuchFunction"), nullptr);
}

TEST(GlContext, AutomaticPrefersOsMesa) {
    EXPECT_EQ(make_gl_context(RenderingBackend::automatic)->backend(), "OSMesa");
}

TEST(GlContext, AlternatingBackendsDrawTheSameBytes) {
    const scene::Model model = tower_scene();
    Renderer osmesa(std::span(&model, 1), quick_settings(), make_osmesa_context());
    Renderer egl(std::span(&model, 1), quick_settings(), make_egl_context());
    const Image first = osmesa.draw(tower_view(), kWidth, kHeight);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(egl.draw(tower_view(), kWidth, kHeight).rgba, first.rgba);
        EXPECT_EQ(osmesa.draw(tower_view(), kWidth, kHeight).rgba, first.rgba);
    }
}

TEST(GlContext, DestroyingOneBackendLeavesTheOtherUsable) {
    const scene::Model model = tower_scene();
    for (const bool destroy_egl : {true, false}) {
        auto doomed = std::make_unique<Renderer>(std::span(&model, 1), quick_settings(),
                                                 destroy_egl ? make_egl_context() : make_osmesa_context());
        Renderer survivor(std::span(&model, 1), quick_settings(),
                          destroy_egl ? make_osmesa_context() : make_egl_context());
        const Image before = survivor.draw(tower_view(), kWidth, kHeight);
        doomed->draw(tower_view(), kWidth, kHeight);
        doomed.reset();
        EXPECT_EQ(survivor.draw(tower_view(), kWidth, kHeight).rgba, before.rgba);
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
