#include "tools/campuswalk/base/canonical_paths.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace campuswalk::tools {
namespace {

namespace fs = std::filesystem;

TEST(CanonicalPaths, AreThoseOfTheStandardLibrary) {
    const support::TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    fs::create_directories(folder / "a" / "b");
    std::ofstream(folder / "a" / "file") << "words";
    fs::create_symlink("a", folder / "link");
    fs::create_symlink("../a/file", folder / "a" / "to-file");
    fs::create_symlink("nowhere", folder / "a" / "broken");
    CanonicalPaths canonical;
    for (int round = 0; round < 2; ++round) {  // the second time, each folder is known
        for (const char* path : {"a/file", "a/b", "a/b/", "a/./file", "a/b/../file", "link/file",
                                 "link/b/../file", "a/to-file", "link/to-file", "a/missing", "missing/too",
                                 "missing/../a/file", "a/.", "a/..", "a/broken/on", ""}) {
            const fs::path file = folder / path;
            EXPECT_EQ(canonical.of(file).lexically_normal(), fs::weakly_canonical(file).lexically_normal())
                << path;
        }
    }
    const fs::path here = fs::current_path();
    EXPECT_EQ(canonical.of("file"), fs::weakly_canonical(here) / "file");
    EXPECT_EQ(canonical.of("./file"), fs::weakly_canonical(here) / "file");
}

}  // namespace
}  // namespace campuswalk::tools
