#include "engine/render/image/row_bands.h"

#include <gtest/gtest.h>

namespace campuswalk::engine::render::test {
namespace {

TEST(RowBands, CoverEachRowOnce) {
    for (const int rows : {0, 1, 63, 64, 129, 720, 4321}) {
        std::vector<int> visits(static_cast<std::size_t>(rows), 0);
        for_row_bands(rows, [&](int first, int end) {
            for (int y = first; y < end; ++y) {
                ++visits[static_cast<std::size_t>(y)];
            }
        });
        EXPECT_EQ(visits, std::vector<int>(static_cast<std::size_t>(rows), 1));
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
