#include "config/loader/yaml/source_text.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/support/says.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::config {
namespace {

using support::says;

class SourceText : public testing::Test {
protected:
    /// The diagnostic about a file of these bytes, empty when it can be read.
    std::string about(std::string_view bytes) {
        folder_.write("a.yaml", bytes);
        return about_path("a.yaml");
    }

    std::string about_path(const std::string& name,
                           const scene::SourceMark& referenced_at = {"a.walk.yaml", 3, 9}) {
        scene::DiagnosticList diagnostics;
        text_ = read_source(folder_.path() / name, referenced_at, diagnostics);
        EXPECT_EQ(text_.has_value(), diagnostics.all().empty());
        if (text_) {
            return "";
        }
        std::string line = scene::to_string(diagnostics.all().at(0));
        const std::string prefix = folder_.path().string() + "/";
        if (const std::size_t at = line.find(prefix); at != std::string::npos) {
            line.erase(at, prefix.size());
        }
        return line;
    }

    support::TemporaryFolder folder_;
    std::optional<std::string> text_;
};

TEST_F(SourceText, DropsByteOrderMarkAndCarriageReturns) {
    EXPECT_EQ(about("\xEF\xBB\xBF"
                    "a: 1\r\nb: 2\r\n"),
              "");
    EXPECT_EQ(text_, "a: 1\nb: 2\n");
    EXPECT_EQ(about(""), "");
    EXPECT_EQ(text_, "");
}

TEST_F(SourceText, RefusesTabsInIndentation) {
    EXPECT_THAT(about("a:\n\tb: 1\n"), says("a.yaml:2:1: error yaml-syntax"));
    EXPECT_THAT(about("a:\n  \tb: 1\n"), says("a.yaml:2:3: error yaml-syntax"));
    EXPECT_EQ(about("a:\t1\t# a comment\n"), "");
}

TEST_F(SourceText, RefusesDirectives) {
    EXPECT_THAT(about("a: 1\n%b: 2\n"), says("a.yaml:2:1: error yaml-syntax"));
    EXPECT_EQ(about("a: 10 %\n"), "");
}

TEST_F(SourceText, RefusesControlCharactersAndInvalidUtf8) {
    EXPECT_THAT(about(std::string("a: \0\n", 5)), says("a.yaml:1:4: error yaml-syntax"));
    EXPECT_THAT(about("é: \x7F"), says("a.yaml:1:4: error yaml-syntax"));
    EXPECT_THAT(about("a\rb"), says("a.yaml:1:2: error yaml-syntax"));
    EXPECT_THAT(about("\xFF\xFE"
                      "a"),
                says("a.yaml:1:1: error yaml-syntax"));
    EXPECT_THAT(about("a: caf\xE9\n"), says("a.yaml:1:7: error yaml-syntax"));
}

TEST_F(SourceText, ReportsPathsThatAreNotRegularFiles) {
    EXPECT_THAT(about_path("none.yaml"), says("a.walk.yaml:3:9: error missing-file", {"'none.yaml'"}));
    folder_.write("folder/a.yaml", "");
    EXPECT_THAT(about_path("folder"), says("a.walk.yaml:3:9: error missing-file", {"'folder'"}));
    EXPECT_THAT(about_path("folder/a.yaml/b.yaml"),
                says("a.walk.yaml:3:9: error missing-file", {"'folder/a.yaml/b.yaml'"}));
    ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(about_path("pipe"), says("a.walk.yaml:3:9: error missing-file", {"'pipe'"}));
    EXPECT_THAT(about_path("none.yaml", {"none.yaml", 0, 0}), says("none.yaml: error missing-file"));
}

TEST_F(SourceText, ReportsUnreadableFiles) {
    folder_.write("secret.yaml", "a: 1\n");
    ASSERT_EQ(chmod((folder_.path() / "secret.yaml").c_str(), 0), 0);
    if (access((folder_.path() / "secret.yaml").c_str(), R_OK) == 0) {
        GTEST_SKIP() << "root may read everything";
    }
    EXPECT_THAT(about_path("secret.yaml"), says("a.walk.yaml:3:9: error missing-file", {"'secret.yaml'"}));
}

TEST_F(SourceText, RefusesFilesOverEightMegabytes) {
    EXPECT_THAT(about(std::string(8'000'001, '#')), says("a.yaml: error too-large"));
    EXPECT_EQ(about(std::string(8'000'000, '#')), "");
}

}  // namespace
}  // namespace campuswalk::config
