#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config::test {

/// For stories about `steps` in a walk that has nothing else wrong.
class StepsFixture : public testing::Test {
protected:
    /// The steps that are played; the text must be right.
    std::vector<engine::Step> read(const std::string& text) {
        EXPECT_THAT(folder_.about_steps(text), testing::ElementsAre());
        return folder_.run().walk.steps;
    }

    /// What is said about a second step.
    Lines about(const std::string& step) const {
        return folder_.about_steps("  - spawn: gate\n  - " + step + "\n");
    }

    ConfigFolder folder_;
};

}  // namespace campuswalk::config::test
