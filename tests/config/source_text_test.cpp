#include "config/loader/source_text.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace campuswalk::config {
namespace {

class SourceText : public testing::Test {
protected:
    /// The diagnostic about a file of these bytes, empty when it can be read.
    std::string about(std::string_view bytes) {
        folder_.write("a.yaml", bytes);
        return about_path("a.yaml");
    }

    std::string about_path(const std::string& name, scene::SourceMark asked_at = {"a.walk.yaml", 3, 9}) {
        scene::DiagnosticList diagnostics;
        text_ = read_source(folder_.path() / name, asked_at, diagnostics);
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

TEST_F(SourceText, RefusesTabsThatIndent) {
    EXPECT_EQ(about("a:\n\tb: 1\n"),
              "a.yaml:2:1: error yaml-syntax: a tab indents this line; indent with spaces");
    EXPECT_EQ(about("a:\n  \tb: 1\n"),
              "a.yaml:2:3: error yaml-syntax: a tab indents this line; indent with spaces");
    EXPECT_EQ(about("a:\t1\t# a comment\n"), "");
}

TEST_F(SourceText, RefusesDirectives) {
    EXPECT_EQ(
        about("a: 1\n%b: 2\n"),
        "a.yaml:2:1: error yaml-syntax: a line can't start with '%' (the YAML parser would skip it); put the "
        "text in quotes");
    EXPECT_EQ(about("a: 10 %\n"), "");
}

TEST_F(SourceText, RefusesBinary) {
    EXPECT_EQ(about(std::string("a: \0\n", 5)),
              "a.yaml:1:4: error yaml-syntax: a control character (byte 0): this is not a text file, or the "
              "character must go");
    EXPECT_EQ(about("é: \x7F"),
              "a.yaml:1:4: error yaml-syntax: a control character (byte 127): this is not a "
              "text file, or the character must go");
    EXPECT_EQ(about("a\rb"),
              "a.yaml:1:2: error yaml-syntax: a control character (byte 13): this is not a text "
              "file, or the character must go");
    EXPECT_EQ(about("\xFF\xFE"
                    "a"),
              "a.yaml:1:1: error yaml-syntax: not UTF-8 text; save the file as UTF-8");
    EXPECT_EQ(about("a: caf\xE9\n"), "a.yaml:1:7: error yaml-syntax: not UTF-8 text; save the file as UTF-8");
}

TEST_F(SourceText, SaysWhyAFileCannotBeRead) {
    EXPECT_EQ(about_path("none.yaml"),
              "a.walk.yaml:3:9: error missing-file: 'none.yaml': no such file; check the path");
    folder_.write("folder/a.yaml", "");
    EXPECT_EQ(about_path("folder"),
              "a.walk.yaml:3:9: error missing-file: 'folder': is a folder; name a file in it");
    EXPECT_EQ(about_path("folder/a.yaml/b.yaml"),
              "a.walk.yaml:3:9: error missing-file: 'folder/a.yaml/b.yaml': no such file; check the path");
    ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(about_path("pipe"), "a.walk.yaml:3:9: error missing-file: 'pipe': is not a regular file");
    EXPECT_EQ(about_path("none.yaml", {"none.yaml", 0, 0}),
              "none.yaml: error missing-file: no such file; check the path");
}

TEST_F(SourceText, SaysThatAFileIsNotReadable) {
    folder_.write("secret.yaml", "a: 1\n");
    ASSERT_EQ(chmod((folder_.path() / "secret.yaml").c_str(), 0), 0);
    if (access((folder_.path() / "secret.yaml").c_str(), R_OK) == 0) {
        GTEST_SKIP() << "root may read everything";
    }
    EXPECT_EQ(about_path("secret.yaml"),
              "a.walk.yaml:3:9: error missing-file: 'secret.yaml': cannot be read; check its permissions");
}

TEST_F(SourceText, RefusesFilesThatAreNoConfiguration) {
    EXPECT_EQ(about(std::string(2'000'001, '#')),
              "a.yaml: error too-large: the file has 2000001 bytes; at most 2000000 are read");
    EXPECT_EQ(about(std::string(2'000'000, '#')), "");
}

TEST(Utf8Length, KnowsEveryForm) {
    EXPECT_EQ(utf8_length("a", 0), 1U);
    EXPECT_EQ(utf8_length("é", 0), 2U);
    EXPECT_EQ(utf8_length("总", 0), 3U);
    EXPECT_EQ(utf8_length("🌳", 0), 4U);
    EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF", 0), 4U);  // the last code point
}

TEST(Utf8Length, RefusesWhatIsNone) {
    for (const char* bytes :
         {"\x80", "\xC3", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE6\x80", "\xED\xA0\x80",
          "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xC3(", "\xE6\x80("}) {
        EXPECT_EQ(utf8_length(bytes, 0), 0U) << bytes;
    }
}

}  // namespace
}  // namespace campuswalk::config
