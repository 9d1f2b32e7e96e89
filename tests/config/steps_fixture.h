#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config::test {

/// For tests of `steps` in a walk that is otherwise valid.
class StepsFixture : public testing::Test {
protected:
    /// The unrolled steps; the text must be valid.
    std::vector<engine::Step> read(const std::string& text) {
        EXPECT_THAT(folder_.about_steps(text), testing::ElementsAre());
        return folder_.run().walk.steps;
    }

    /// The diagnostics of a second step, on line 4.
    Lines about(const std::string& step) const {
        return folder_.about_steps("  - spawn: gate\n  - " + step + "\n");
    }

    ConfigFolder folder_;
};

}  // namespace campuswalk::config::test
