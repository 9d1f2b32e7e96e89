#include "engine/report/artifact_path.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

TEST(ArtifactPath, LeadsIntoTheOutputFolder) {
    for (const char* path :
         {"a.png", "a/b/c.json", "図書館/x.png", "a..b/d..", "a[1]/b.png", "a b", "%41", "xy:z"}) {
        EXPECT_TRUE(is_artifact_path(path)) << path;
    }
    for (const char* path : {"",      "/etc/passwd", "..",      "../x",        "a/../../x", "a/..",  ".",
                             "./a",   "a/./b",       "a//b",    "a/",          "C:/x",      "c:x",   "a\\b",
                             "..\\x", "a|b",         "a]]b",    ".git/config", "a/.b",      "a/..c", "[[a",
                             "a\nb",  "a\x1b",       "a\u202e", "caf\xe9",     "a\xe2\x82", "\x80"}) {
        EXPECT_FALSE(is_artifact_path(path)) << path;
    }
}

TEST(ArtifactPath, IsMadeOfAnyName) {
    EXPECT_EQ(to_artifact_path("walks/visit [1] 図書館"), "walks/visit [1] 図書館");
    EXPECT_EQ(to_artifact_path("a]]|b"), "a]%5D%7Cb");
    EXPECT_EQ(to_artifact_path(".git/../b.c"), "%2Egit/%2E./b.c");
    EXPECT_EQ(to_artifact_path("C:x\\y\n\u202e"), "C%3Ax%5Cy%0A%E2%80%AE");
}

TEST(ArtifactPath, OfDifferentNamesDiffers) {
    std::set<std::string> names;
    std::set<std::string> paths;
    const std::string odd = "]|[%5D7:a\\\xe9";
    for (std::size_t i = 0; i < odd.size() * odd.size() * odd.size() * odd.size(); ++i) {
        std::string name;
        for (std::size_t rest = i; name.size() < 4; rest /= odd.size()) {
            name += odd[rest % odd.size()];
        }
        names.insert(name);
        paths.insert(to_artifact_path(name));
        EXPECT_TRUE(is_artifact_path(to_artifact_path(name))) << name;
    }
    EXPECT_EQ(names.size(), paths.size());
}

TEST(ArtifactPath, HasAMediaType) {
    EXPECT_TRUE(is_media_type("image/svg+xml"));
    for (const char* text : {"", "image", "image/", "/png", "image/p ng", "a/b/c", "a/\"b"}) {
        EXPECT_FALSE(is_media_type(text)) << text;
    }
}

}  // namespace
}  // namespace campuswalk::engine
