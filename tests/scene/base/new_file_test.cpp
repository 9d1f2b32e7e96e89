#include "scene/base/new_file.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <future>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(NewFile, MakesItsFoldersAndReplacesAnOlderOne) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "a" / "b" / "c.txt";
    write_new_file(file, "first and long");
    EXPECT_EQ(contents_of(file), "first and long");
    write_new_file(file, "second");
    EXPECT_EQ(contents_of(file), "second");
}

TEST(NewFile, ReplacesALinkInsteadOfFollowingIt) {
    const support::TemporaryFolder folder;
    folder.write("precious.txt", "precious");
    for (const char* target : {"precious.txt", "missing.txt"}) {
        const fs::path file = folder.path() / (std::string("link-to-") + target);
        fs::create_symlink(folder.path() / target, file);
        write_new_file(file, "mine");
        EXPECT_FALSE(fs::is_symlink(file));
        EXPECT_EQ(contents_of(file), "mine");
    }
    EXPECT_EQ(contents_of(folder.path() / "precious.txt"), "precious");
    EXPECT_FALSE(fs::exists(folder.path() / "missing.txt"));
}

TEST(NewFile, IsWrittenByManyAtOnce) {
    const support::TemporaryFolder folder;
    const auto write_often = [&] {
        for (int i = 0; i < 500; ++i) {
            write_new_file(folder.path() / "new" / "same.txt", "whole");
        }
    };
    std::vector<std::future<void>> writers;
    for (int i = 0; i < 4; ++i) {
        writers.push_back(std::async(std::launch::async, write_often));
    }
    for (std::future<void>& writer : writers) {
        EXPECT_NO_THROW(writer.get());
    }
    EXPECT_EQ(contents_of(folder.path() / "new" / "same.txt"), "whole");
}

TEST(NewFile, ReplacesAFileThatHasAnotherName) {
    const support::TemporaryFolder folder;
    folder.write("precious.txt", "precious");
    fs::create_hard_link(folder.path() / "precious.txt", folder.path() / "stream.log");
    EXPECT_EQ(std::fputs("mine", open_new_file(folder.path() / "stream.log").get()), 1);
    EXPECT_EQ(contents_of(folder.path() / "stream.log"), "mine");
    EXPECT_EQ(contents_of(folder.path() / "precious.txt"), "precious");
}

TEST(NewFile, RefusesAPipeAtOnce) {
    const support::TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(open_new_file(folder.path() / "pipe"), std::runtime_error);
    EXPECT_TRUE(fs::is_fifo(folder.path() / "pipe"));
}

TEST(NewFile, KnowsStreams) {
    const support::TemporaryFolder folder;
    folder.write("file", "");
    ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    fs::create_symlink("pipe", folder.path() / "link-to-pipe");
    fs::create_symlink("file", folder.path() / "link-to-file");
    fs::create_symlink("/dev/stdout", folder.path() / "link-to-stdout");
    for (const char* name : {"pipe", "link-to-pipe", "link-to-stdout"}) {
        EXPECT_TRUE(is_stream(folder.path() / name)) << name;
    }
    for (const char* name : {"file", "link-to-file", "missing", "missing/too", ""}) {
        EXPECT_FALSE(is_stream(folder.path() / name)) << name;
    }
    for (const char* name : {"/dev/null", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        EXPECT_TRUE(is_stream(name)) << name;
    }
}

TEST(NewFile, FailsOnAFolderAndBelowAFile) {
    const support::TemporaryFolder folder;
    folder.write("a", "a file");
    fs::create_directory(folder.path() / "b");
    EXPECT_THROW(write_new_file(folder.path() / "a" / "c.txt", "text"), std::runtime_error);
    EXPECT_THROW(write_new_file(folder.path() / "b", "text"), std::runtime_error);
    EXPECT_EQ(contents_of(folder.path() / "a"), "a file");
    EXPECT_TRUE(fs::is_directory(folder.path() / "b"));
}

/// A limit that stands for a full disk.
TEST(NewFile, LeavesNothingWhenItDoesNotFit) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "large.txt";
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100'000, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(write_new_file(file, std::string(1'000'000, 'x')), std::runtime_error);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace campuswalk::scene
