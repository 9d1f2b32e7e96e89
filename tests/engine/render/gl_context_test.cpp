#include "engine/render/gl_context.h"

#include <gtest/gtest.h>

#include "engine/render/gl_functions.h"

namespace campuswalk::engine::render {
namespace {

TEST(OsMesaContext, OffersGl33AndNothingForUnknownNames) {
    const auto context = make_osmesa_context();
    EXPECT_EQ(context->backend(), "OSMesa");
    const GlFunctions gl = load_gl_functions(*context);
    GLint major = 0;
    GLint minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_EQ(context->procedure("noSuchFunction"), nullptr);
}

TEST(OsMesaContext, SeveralLiveSideBySide) {
    const auto first = make_osmesa_context();
    const auto second = make_osmesa_context();
    for (GlContext* context : {first.get(), second.get(), first.get()}) {
        EXPECT_NO_THROW(context->make_current());
        EXPECT_EQ(load_gl_functions(*context).GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

}  // namespace
}  // namespace campuswalk::engine::render
