#include "scene/base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

/// Another process with the same id may be writing it, for example in another container.
TEST(AtomicFile, LeavesTemporaryFilesThatAreBeingWritten) {
    const support::TemporaryFolder folder;
    const std::string foreign = "c.txt.campuswalk-" + std::to_string(getpid()) + "-0.part";
    folder.write(foreign, "of somebody else");
    const int descriptor = open((folder.path() / foreign).c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
    write_file_atomically(folder.path() / "c.txt", "mine");
    EXPECT_EQ(text_of(folder.path() / "c.txt"), "mine");
    EXPECT_EQ(text_of(folder.path() / foreign), "of somebody else");
    EXPECT_EQ(files_in(folder.path()), 2);
    close(descriptor);
}

TEST(AtomicFile, RemovesWhatKilledProcessesHaveLeft) {
    const support::TemporaryFolder folder;
    const std::vector<std::string> others = {"a.part",
                                             "backup.2024-06.part",
                                             "b.campuswalk-1.part",
                                             "c.campuswalk-1-.part",
                                             "d.campuswalk--0.part",
                                             ".campuswalk-1-0.part",
                                             "e.campuswalk-x-0.part"};
    for (const std::string& name : others) {
        folder.write(name, "a download of somebody else");
    }
    folder.write("c.txt.campuswalk-123-0.part", "half");
    folder.write("d.png.campuswalk-4567890-12.part", "half");
    folder.write("victim", "precious");
    fs::create_symlink(folder.path() / "victim", folder.path() / "e.png.campuswalk-1-0.part");
    ASSERT_EQ(mkfifo((folder.path() / "f.png.campuswalk-1-0.part").c_str(), 0600), 0);
    write_file_atomically(folder.path() / "c.txt", "whole");
    EXPECT_FALSE(fs::exists(folder.path() / "c.txt.campuswalk-123-0.part"));
    EXPECT_FALSE(fs::exists(folder.path() / "d.png.campuswalk-4567890-12.part"));
    EXPECT_EQ(files_in(folder.path()), static_cast<std::ptrdiff_t>(others.size()) + 4);
}

/// As another process would look for what is left there, while the file is closed, renamed and its lock
/// given up.
TEST(AtomicFile, HoldsItsLockUntilTheFileHasItsName) {
    const support::TemporaryFolder folder;
    AtomicFile out(folder.path() / "c.txt");
    const int descriptor = open(out.temporary().c_str(), O_RDWR | O_CLOEXEC);
    EXPECT_NE(flock(descriptor, LOCK_EX | LOCK_NB), 0);
    out.finish();
    EXPECT_EQ(flock(descriptor, LOCK_EX | LOCK_NB), 0);
    close(descriptor);
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
