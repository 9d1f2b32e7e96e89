#include "scene/base/atomic_file.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(AtomicFile, ReplacesAFileAndCreatesItsFolders) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "a" / "b" / "c.txt";
    write_file_atomically(file, "first and long");
    write_file_atomically(file, "second");
    EXPECT_EQ(text_of(file), "second");
    EXPECT_EQ(files_in(file.parent_path()), 1);
}

/// Another process with the same id may have left it, for example in another container.
TEST(AtomicFile, LeavesForeignTemporaryFilesAlone) {
    const support::TemporaryFolder folder;
    const std::string foreign = "c.txt." + std::to_string(getpid()) + "-0.part";
    folder.write(foreign, "of somebody else");
    write_file_atomically(folder.path() / "c.txt", "mine");
    EXPECT_EQ(text_of(folder.path() / "c.txt"), "mine");
    EXPECT_EQ(text_of(folder.path() / foreign), "of somebody else");
    EXPECT_EQ(files_in(folder.path()), 2);
}

std::span<const std::byte> bytes(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(AtomicFile, ReplacesTheFileOnFinish) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "c.txt";
    write_file_atomically(file, "before");
    {
        AtomicFile out(file);
        out.write(bytes("0000 and "));
        out.replace(2, bytes("12"));
        out.write(bytes("more"));
        EXPECT_EQ(text_of(file), "before");
        out.finish();
    }
    EXPECT_EQ(text_of(file), "0012 and more");
    EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, LeavesNothingIfNotFinished) {
    const support::TemporaryFolder folder;
    {
        AtomicFile out(folder.path() / "c.txt");
        out.write(bytes("half"));
        EXPECT_EQ(files_in(folder.path()), 1);
    }
    EXPECT_EQ(files_in(folder.path()), 0);
}

TEST(AtomicFile, NeverReplacesADevice) {
    EXPECT_THROW(write_file_atomically("/dev/null", "x"), std::runtime_error);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace campuswalk::scene
