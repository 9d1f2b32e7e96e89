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

TEST(AtomicFile, ReplacesAFileAndMakesItsFolders) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "a" / "b" / "c.txt";
    write_file_atomically(file, "first and long");
    write_file_atomically(file, "second");
    EXPECT_EQ(text_of(file), "second");
    EXPECT_EQ(files_in(file.parent_path()), 1);
}

/// A process of the same number may have been killed, here or in another container.
TEST(AtomicFile, LeavesNeighboursOfOthersAlone) {
    const support::TemporaryFolder folder;
    const std::string others = "c.txt." + std::to_string(getpid()) + "-0.part";
    folder.write(others, "of somebody else");
    write_file_atomically(folder.path() / "c.txt", "mine");
    EXPECT_EQ(text_of(folder.path() / "c.txt"), "mine");
    EXPECT_EQ(text_of(folder.path() / others), "of somebody else");
    EXPECT_EQ(files_in(folder.path()), 2);
}

std::span<const std::byte> bytes(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(AtomicFile, IsThereOnceItIsFinished) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "c.txt";
    write_file_atomically(file, "before");
    {
        AtomicFile whole(file);
        whole.write(bytes("0000 and "));
        whole.replace(2, bytes("12"));
        whole.write(bytes("more"));
        EXPECT_EQ(text_of(file), "before");
        whole.finish();
    }
    EXPECT_EQ(text_of(file), "0012 and more");
    EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, IsNothingWhenItIsGivenUp) {
    const support::TemporaryFolder folder;
    {
        AtomicFile whole(folder.path() / "c.txt");
        whole.write(bytes("half"));
        EXPECT_EQ(files_in(folder.path()), 1);
    }
    EXPECT_EQ(files_in(folder.path()), 0);
}

TEST(AtomicFile, PutsNoFileInADevicesPlace) {
    EXPECT_THROW(write_file_atomically("/dev/null", "x"), std::runtime_error);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace campuswalk::scene
