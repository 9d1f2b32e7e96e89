#include "scene/base/diagnostic_code.h"

#include <string>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

TEST(DiagnosticCode, IsFoundByItsText) {
    for (const std::string_view text : kDiagnosticCodes) {
        const std::optional<DiagnosticCode> code = DiagnosticCode::find(text);
        ASSERT_TRUE(code) << text;
        EXPECT_EQ(code->text(), text);
    }
    EXPECT_EQ(DiagnosticCode::find("bad-map"), DiagnosticCode("bad-map"));
    EXPECT_NE(DiagnosticCode::find("bad-map"), DiagnosticCode("bad-model"));
}

TEST(DiagnosticCode, IsOneOfTheTableOrNone) {
    for (const std::string text : {"", "bad", "bad-map ", "Bad-map", "zz"}) {
        EXPECT_FALSE(DiagnosticCode::find(text)) << text;
    }
    EXPECT_TRUE(DiagnosticCode().empty());
    EXPECT_FALSE(DiagnosticCode("bad-map").empty());
}

}  // namespace
}  // namespace campuswalk::scene
