#include "scene/base/why_unreadable.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace campuswalk::scene {
namespace {

TEST(WhyUnreadable, NamesTheObstacle) {
    const support::TemporaryFolder folder;
    folder.write("file.txt", "text");
    std::filesystem::create_symlink("missing.txt", folder.path() / "link.txt");
    ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(why_unreadable(folder.path() / "file.txt"), "");
    EXPECT_EQ(why_unreadable(folder.path() / "missing.txt"), "no such file; check the path");
    EXPECT_EQ(why_unreadable(folder.path() / "link.txt"), "no such file; check the path");
    EXPECT_EQ(why_unreadable(folder.path()), "it is a folder; name a file");
    for (const std::filesystem::path& endless :
         {folder.path() / "pipe", std::filesystem::path("/dev/zero")}) {
        EXPECT_EQ(why_unreadable(endless),
                  "it is a pipe, a socket or a device; write what it gives to a file, and name that");
    }
    EXPECT_NE(why_unreadable(folder.path() / "file.txt" / "below"), "");
}

/// In a process of its own, as the superuser may read everything. It ends at once, since LeakSanitizer may
/// not look at a process that has changed its user.
TEST(WhyUnreadable, TellsThatThePermissionIsMissing) {
    const support::TemporaryFolder folder;
    folder.write("file.txt", "text");
    ASSERT_EQ(chmod(folder.path().c_str(), 0755), 0);
    ASSERT_EQ(chmod((folder.path() / "file.txt").c_str(), 0), 0);
    const auto why_for_nobody = [&] {
        constexpr uid_t kNobody = 65534;
        return geteuid() == 0 && seteuid(kNobody) != 0 ? "" : why_unreadable(folder.path() / "file.txt");
    };
    const char* denied = "it can't be read: Permission denied; check its permissions";
    EXPECT_EXIT(std::_Exit(why_for_nobody() == denied ? 0 : 1), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace campuswalk::scene
