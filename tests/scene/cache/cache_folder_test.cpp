#include "scene/cache/cache_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <future>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/base/binary_archive.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

constexpr ContentHash kA{{1}};
constexpr ContentHash kB{{2}};
constexpr ContentHash kC{{3}};

class CacheFolderTest : public testing::Test {
protected:
    static void store(const CacheFolder& cache, const ContentHash& key, std::size_t size) {
        const std::vector<std::byte> bytes(size, std::byte{7});
        cache.store(key, "model", BufferSequence{bytes});
    }
    CacheFolder reporting_cache(const fs::path& where) {
        return CacheFolder(where, CacheFolder::kDefaultLimit,
                           [this](const std::string& reason) { diagnostics_.push_back(reason); });
    }
    fs::path file_of(const ContentHash& key) const { return where_ / (to_string(key) + ".model.campuswalk"); }
    std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(where_), fs::directory_iterator());
    }
    /// Sets the time of the last use.
    void set_used(const ContentHash& key, time_t seconds) const {
        const timespec times[2] = {{seconds, 0}, {seconds, 0}};
        ASSERT_EQ(utimensat(AT_FDCWD, file_of(key).c_str(), times, 0), 0);
    }

    std::vector<std::string> diagnostics_;
    support::TemporaryFolder folder_;
    fs::path where_ = folder_.path() / "deep" / "cache";
};

TEST_F(CacheFolderTest, FindsFilesByKeyAndKind) {
    const CacheFolder cache = reporting_cache(where_);
    EXPECT_FALSE(cache.find(kA, "model"));
    store(cache, kA, 5);
    EXPECT_TRUE(diagnostics_.empty());
    const auto found = cache.find(kA, "model");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->bytes().size(), 5U);
    EXPECT_EQ(found->bytes()[4], std::byte{7});
    EXPECT_FALSE(cache.find(kA, "trees"));
    EXPECT_FALSE(cache.find(kB, "model"));
    EXPECT_EQ(files(), 1);
    EXPECT_EQ(fs::status(where_).permissions() & fs::perms(077), fs::perms::none);
}

TEST_F(CacheFolderTest, EvictsTheLeastRecentlyUsedFile) {
    const CacheFolder cache(where_, 250);
    store(cache, kA, 100);
    store(cache, kB, 100);
    set_used(kA, 1000);
    set_used(kB, 2000);
    EXPECT_TRUE(cache.find(kA, "model"));  // B is now the least recently used
    store(cache, kC, 100);
    EXPECT_TRUE(cache.find(kA, "model"));
    EXPECT_FALSE(cache.find(kB, "model"));
    EXPECT_TRUE(cache.find(kC, "model"));
}

TEST_F(CacheFolderTest, DoesNotStoreAFileLargerThanTheLimit) {
    const CacheFolder cache(where_, 250);
    store(cache, kA, 100);
    store(cache, kB, 251);
    EXPECT_FALSE(cache.find(kB, "model"));
    EXPECT_TRUE(cache.find(kA, "model"));
}

/// The user may choose any folder.
TEST_F(CacheFolderTest, NeverRemovesForeignFiles) {
    const std::string hash = to_string(kA);
    for (const std::string& name :
         {std::string("thesis.pdf"), hash, hash + ".model", "x" + hash + ".campuswalk"}) {
        folder_.write("deep/cache/" + name, std::string(500, 'x'));
    }
    fs::create_directories(where_ / (hash + ".folder.campuswalk"));
    folder_.write("deep/cache/" + hash + ".model.campuswalk.123-0.part", std::string(500, 'x'));
    const CacheFolder cache(where_, 250);
    store(cache, kB, 100);
    EXPECT_EQ(files(), 6) << "the temporary file of a killed process is removed";
    EXPECT_TRUE(cache.find(kB, "model"));
}

TEST_F(CacheFolderTest, ReportsWriteErrors) {
    folder_.write("file", "not a folder");
    const CacheFolder cache = reporting_cache(folder_.path() / "file" / "cache");
    store(cache, kA, 1);
    ASSERT_EQ(diagnostics_.size(), 1U);
    EXPECT_NE(diagnostics_[0].find("cache"), std::string::npos) << diagnostics_[0];
    EXPECT_FALSE(cache.find(kA, "model"));
}

TEST_F(CacheFolderTest, ReadsRegularFilesOnly) {
    const CacheFolder cache = reporting_cache(where_);
    fs::create_directories(where_);
    ASSERT_EQ(mkfifo(file_of(kA).c_str(), 0600), 0);
    EXPECT_FALSE(cache.find(kA, "model")) << "and does not block";
    store(cache, kA, 3);
    EXPECT_EQ(diagnostics_.size(), 1U);
}

TEST_F(CacheFolderTest, FoundBytesStayTheSameWhenTheFileIsRewrittenOrTruncated) {
    const CacheFolder cache(where_);
    store(cache, kA, 5000);
    const auto found = cache.find(kA, "model");
    ASSERT_TRUE(found);
    ASSERT_EQ(found->bytes().size(), 5000U);
    std::ofstream(file_of(kA), std::ios::in) << "changed";
    fs::resize_file(file_of(kA), 100);
    EXPECT_EQ(found->bytes()[0], std::byte{7});
    EXPECT_EQ(found->bytes()[4999], std::byte{7});
}

TEST_F(CacheFolderTest, ClaimsAreOfOneKeyEach) {
    const CacheFolder cache = reporting_cache(where_);
    const auto claim = cache.claim(kA);
    EXPECT_TRUE(claim);
    const fs::path file = where_ / "claims.campuswalk";
    ASSERT_TRUE(fs::exists(file));
    EXPECT_TRUE(CacheClaim::wait_or_take(file, kB, std::chrono::hours(1))) << "at once";
}

TEST_F(CacheFolderTest, WhoComesTooLateForAClaimWaitsForItsEnd) {
    const CacheFolder cache = reporting_cache(where_);
    auto claim = cache.claim(kA);
    auto other = std::async(std::launch::async, [&] { return CacheFolder(where_).claim(kA).has_value(); });
    EXPECT_EQ(other.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
    claim.reset();
    EXPECT_FALSE(other.get());
    EXPECT_TRUE(cache.claim(kA)) << "who waited has none";
}

/// As if whoever has it were stopped in a debugger.
TEST_F(CacheFolderTest, NobodyWaitsForEverForAClaim) {
    const CacheFolder cache = reporting_cache(where_);
    const auto claim = cache.claim(kA);
    EXPECT_TRUE(CacheClaim::wait_or_take(where_ / "claims.campuswalk", kA, std::chrono::milliseconds(50)));
}

TEST_F(CacheFolderTest, AClaimEndsWithItsProcess) {
    const CacheFolder cache = reporting_cache(where_);
    const pid_t child = fork();
    if (child == 0) {
        const auto claim = cache.claim(kA);
        _exit(claim ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(cache.claim(kA));
}

TEST_F(CacheFolderTest, EverybodyHasTheClaimWhereNothingCanBeStored) {
    folder_.write("file", "not a folder");
    const CacheFolder cache = reporting_cache(folder_.path() / "file" / "cache");
    const auto claim = cache.claim(kA);
    EXPECT_TRUE(claim);
    EXPECT_TRUE(cache.claim(kA));
    EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(CacheFolderTest, RefusesWhatOthersMayWriteTo) {
    const CacheFolder cache = reporting_cache(where_);
    const auto others_may_write = [](const fs::path& path, bool may) {
        fs::permissions(path, fs::perms::others_write,
                        may ? fs::perm_options::add : fs::perm_options::remove);
    };
    store(cache, kA, 5);
    EXPECT_EQ(fs::status(file_of(kA)).permissions() & fs::perms(022), fs::perms::none);
    others_may_write(file_of(kA), true);
    EXPECT_FALSE(cache.find(kA, "model"));
    others_may_write(file_of(kA), false);
    EXPECT_TRUE(cache.find(kA, "model"));
    others_may_write(where_, true);
    EXPECT_FALSE(cache.find(kA, "model"));
    EXPECT_TRUE(diagnostics_.empty());
    store(cache, kB, 5);
    ASSERT_EQ(diagnostics_.size(), 1U);
    EXPECT_NE(diagnostics_[0].find(where_.string()), std::string::npos) << diagnostics_[0];
    EXPECT_FALSE(fs::exists(file_of(kB)));
}

TEST_F(CacheFolderTest, RefusesWhatAnotherUserOwns) {
    if (geteuid() != 0) {
        GTEST_SKIP() << "only root can give files away";
    }
    const CacheFolder cache = reporting_cache(where_);
    constexpr uid_t kNobody = 65534;
    store(cache, kA, 5);
    ASSERT_EQ(chown(file_of(kA).c_str(), kNobody, kNobody), 0);
    EXPECT_FALSE(cache.find(kA, "model"));
    ASSERT_EQ(chown(file_of(kA).c_str(), 0, 0), 0);
    EXPECT_TRUE(cache.find(kA, "model"));
    ASSERT_EQ(chown(where_.c_str(), kNobody, kNobody), 0);
    EXPECT_FALSE(cache.find(kA, "model"));
}

TEST_F(CacheFolderTest, ReadsAnEmptyFile) {
    const CacheFolder cache(where_);
    store(cache, kA, 0);
    const auto found = cache.find(kA, "model");
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->bytes().empty());
}

}  // namespace
}  // namespace campuswalk::scene
