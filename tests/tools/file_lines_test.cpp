#include "tools/campuswalk/base/file_lines.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::tools {
namespace {

class FileLinesTest : public testing::Test {
protected:
    /// The code that reading all lines is refused with.
    std::string code_of(const std::string& text) {
        folder_.write("file", text);
        try {
            FileLines lines(file_);
            while (lines.next()) {
            }
        } catch (const scene::InputError& error) {
            return std::string(error.diagnostics().front().code.text());
        }
        return "";
    }

    support::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "file";
};

TEST_F(FileLinesTest, AreTheSameInBlocksOfAnySize) {
    const std::vector<std::string> expected = {"first", "", std::string(300, 'x'), "last"};
    std::string text;
    for (const std::string& line : expected) {
        text += line + "\n";
    }
    folder_.write("file", text + "cut short");
    for (std::size_t block = 1; block < 400; ++block) {
        FileLines lines(file_, block);
        std::vector<std::string> found;
        while (const auto line = lines.next()) {
            found.emplace_back(*line);
            EXPECT_EQ(lines.number(), static_cast<int>(found.size()));
            EXPECT_EQ(text.substr(lines.begin(), line->size() + 1), found.back() + "\n") << block;
            EXPECT_EQ(lines.end(), lines.begin() + line->size() + 1) << block;
        }
        EXPECT_EQ(found, expected) << block;
        EXPECT_FALSE(lines.next()) << block;
        EXPECT_EQ(lines.end(), text.size()) << "a resumed run goes on there";
    }
}

TEST_F(FileLinesTest, BeginWhereALineDoes) {
    folder_.write("file", "first\nsecond\nthird\n");
    FileLines lines(file_, 4, 6);
    EXPECT_EQ(lines.next(), "second");
    EXPECT_EQ(lines.begin(), 6U);
    EXPECT_EQ(lines.next(), "third");
}

TEST_F(FileLinesTest, HaveALongestLength) {
    EXPECT_EQ(code_of(std::string(kLongestLine, 'x') + "\nnext\n"), "");
    EXPECT_EQ(code_of("first\n" + std::string(kLongestLine + 1, 'x') + "\n"), "long-line");
    EXPECT_EQ(code_of("first\n" + std::string(2 * kLongestLine, 'x')), "long-line");
}

TEST_F(FileLinesTest, AreThoseOfAFile) {
    EXPECT_THROW(FileLines(folder_.path()), scene::InputError);
    EXPECT_THROW(FileLines(folder_.path() / "missing"), scene::InputError);
}

}  // namespace
}  // namespace campuswalk::tools
