#include "tools/campuswalk/run/html/foreign_images.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace campuswalk::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What a PNG file of this size begins with.
std::string beginning_of_png(unsigned width, unsigned height) {
    std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    for (const unsigned side : {width, height}) {
        for (const unsigned shift : {24U, 16U, 8U, 0U}) {
            bytes += static_cast<char>((side >> shift) & 0xFFU);
        }
    }
    return bytes;
}

class ReportImages : public testing::Test {
protected:
    /// The indices of those that are shown; standard error in `said_`.
    std::vector<std::size_t> shown(const ImageBudget& budget, const std::vector<std::string>& paths) {
        const engine::ImageReader reader = image_reader(
            [this](const std::vector<std::string_view>& files) {
                groups_.push_back(files.size());
                std::vector<scene::ForeignImage> images;
                for (const std::string_view file : files) {
                    const scene::ImageSize size = *scene::png_size(file);
                    images.push_back({size, std::vector<std::uint8_t>(4 * size.pixels()),
                                      file.ends_with("damaged") ? "is odd" : ""});
                }
                return images;
            },
            budget);
        std::vector<std::size_t> indices;
        testing::internal::CaptureStderr();
        reader(
            [this](const std::string& path) {
                return files_.contains(path) ? std::optional(files_[path]) : std::nullopt;
            },
            paths, [&](std::size_t index, const scene::PixelView&) { indices.push_back(index); });
        said_ = testing::internal::GetCapturedStderr();
        return indices;
    }

    std::map<std::string, std::string> files_;
    std::vector<std::size_t> groups_;  ///< pictures decoded by each process
    std::string said_;
};

TEST_F(ReportImages, AreDecodedTogetherUpToALimit) {
    for (int i = 0; i < 7; ++i) {
        files_["p" + std::to_string(i)] = beginning_of_png(10, 10);
    }
    const std::vector<std::string> paths = {"p0", "p1", "missing", "p2", "p3", "p4", "p5", "p6"};
    EXPECT_THAT(shown({.pixels_at_once = 300}, paths), ElementsAre(0, 1, 3, 4, 5, 6, 7));
    EXPECT_THAT(groups_, ElementsAre(3, 3, 1));
    EXPECT_EQ(said_, "");
}

TEST_F(ReportImages, AreLeftOutWithAWarning) {
    files_["small"] = beginning_of_png(10, 10);
    files_["bomb"] = beginning_of_png(16384, 16384);
    files_["huge"] = beginning_of_png(0xFFFFFFFF, 0xFFFFFFFF);
    files_["empty"] = beginning_of_png(0, 10);
    files_["tga"] = std::string(100, '\2');
    files_["odd"] = beginning_of_png(10, 10) + "damaged";
    EXPECT_THAT(shown({}, {"bomb", "huge", "small", "empty", "tga", "odd"}), ElementsAre(2));
    for (const char* name : {"bomb", "huge", "empty", "tga", "odd"}) {
        EXPECT_THAT(said_, HasSubstr(std::string(name) + ": warning bad-picture: "));
    }
}

TEST_F(ReportImages, OfTheWholeReportHaveABudget) {
    for (int i = 0; i < 4; ++i) {
        files_["p" + std::to_string(i)] = beginning_of_png(10, 10);
    }
    EXPECT_THAT(shown({.pixels_of_all = 399}, {"p0", "p1", "p2", "p3"}), ElementsAre(0, 1, 2));
    EXPECT_THAT(said_, HasSubstr("p3: warning bad-picture: "));
    EXPECT_THAT(said_, HasSubstr("400 pixels"));
}

}  // namespace
}  // namespace campuswalk::tools
