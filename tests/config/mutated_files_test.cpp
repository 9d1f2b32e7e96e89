// However a file is damaged, loading it returns a result or throws diagnostics that point into it.

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "config/loader/load_campus.h"
#include "config/loader/load_profile.h"
#include "config/loader/load_run.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::config {
namespace {

namespace fs = std::filesystem;

using support::Dice;

const fs::path kMutated = fs::path(CAMPUSWALK_SOURCE_FOLDER) / "config";

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::size_t index(Dice& dice, std::size_t count) {
    return static_cast<std::size_t>(dice.below(static_cast<int>(count)));
}

/// Replaces, inserts, removes or repeats a few bytes, or cuts the text off.
std::string with_other_bytes(std::string text, Dice& dice) {
    constexpr std::string_view kTroublesome =
        "{}[]:,-#&*!|>'\"%@`?~ \t\n\r\\0919.eE_azAZ/\0\x07\x7F\x80\xC3\xE9\xFF";
    for (int changes = 1 + dice.below(4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = index(dice, text.size());
        const char byte = dice.chance(0.8) ? kTroublesome[index(dice, kTroublesome.size())]
                                           : static_cast<char>(dice.below(256));
        switch (dice.below(5)) {
            case 0:
                text[at] = byte;
                break;
            case 1:
                text.insert(at, 1, byte);
                break;
            case 2:
                text.erase(at, 1 + index(dice, 8));
                break;
            case 3:
                text.insert(at, text.substr(at, 1 + index(dice, 20)));
                break;
            default:
                text.resize(at);
        }
    }
    return text;
}

/// Removes, copies, swaps, indents or truncates a few lines.
std::string with_other_lines(const std::string& text, Dice& dice) {
    std::vector<std::string> lines = lines_of(text);
    for (int changes = 1 + dice.below(3); changes > 0 && lines.size() > 1; --changes) {
        const std::size_t at = index(dice, lines.size());
        const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
        switch (dice.below(5)) {
            case 0:
                lines.erase(place);
                break;
            case 1:
                lines.insert(place, lines[index(dice, lines.size())]);
                break;
            case 2:
                std::swap(lines[at], lines[index(dice, lines.size())]);
                break;
            case 3:
                lines[at].insert(0, 1 + index(dice, 3), ' ');
                break;
            default:
                lines[at].resize(index(dice, lines[at].size() + 1));
        }
    }
    std::string result;
    for (const std::string& line : lines) {
        result += line + "\n";
    }
    return result;
}

/// A copy of the repository's files, one of which is overwritten with mutations of it.
class MutatedFiles : public testing::Test {
protected:
    MutatedFiles() {
        for (const char* name :
             {"demo.campus.yaml", "walks/first-tour.walk.yaml", "walks/every-step.walk.yaml",
              "walks/fountain-lap.steps.yaml", "avatars/adult.avatar.yaml"}) {
            folder_.write(name, bytes_of(kMutated / name));
        }
    }

    /// Mutates the file and loads it; returns how often that was refused.
    int refused(const std::string& name, int times, const std::function<void(const fs::path&)>& load) {
        const std::string original = bytes_of(kMutated / name);
        Dice dice(1);
        int refusals = 0;
        for (int trial = 0; trial < times && !HasFailure(); ++trial) {
            folder_.write(
                name, dice.chance(0.5) ? with_other_bytes(original, dice) : with_other_lines(original, dice));
            SCOPED_TRACE("trial " + std::to_string(trial));
            try {
                load(folder_.path() / name);
            } catch (const scene::InputError& error) {
                ++refusals;
                check(error.diagnostics());
            }
        }
        return refusals;
    }

    /// The names that a walk may use, without the buildings and colliders that take long to read.
    void write_campus_of_places_only() {
        const std::string campus = bytes_of(kMutated / "demo.campus.yaml");
        folder_.write("demo.campus.yaml",
                      "scenes: [{file: a.glb}]\ncolliders: []\n" + campus.substr(campus.find("\nspawns:")));
    }

    support::TemporaryFolder folder_;

private:
    void check(const std::vector<scene::Diagnostic>& diagnostics) const {
        EXPECT_FALSE(diagnostics.empty());
        for (const scene::Diagnostic& diagnostic : diagnostics) {
            SCOPED_TRACE(scene::to_string(diagnostic));
            EXPECT_FALSE(diagnostic.message.empty());
            EXPECT_FALSE(diagnostic.code.empty());
            EXPECT_EQ(diagnostic.message.find('\n'), std::string::npos);
            const std::string text = bytes_of(diagnostic.mark.file);
            const auto lines = std::ranges::count(text, '\n') + 1;
            EXPECT_GE(diagnostic.mark.line, 0);
            EXPECT_LE(diagnostic.mark.line, lines);
            EXPECT_EQ(diagnostic.mark.line > 0, diagnostic.mark.column > 0);
        }
    }
};

TEST_F(MutatedFiles, WalkIsReadOrRefused) {
    write_campus_of_places_only();
    const int times = support::repeats(1500);
    EXPECT_GT(refused("walks/first-tour.walk.yaml", times, [](const fs::path& file) { load_run(file, {}); }),
              times / 4);
}

TEST_F(MutatedFiles, WalkOfEveryStepIsReadOrRefused) {
    write_campus_of_places_only();
    const int times = support::repeats(1500);
    EXPECT_GT(refused("walks/every-step.walk.yaml", times, [](const fs::path& file) { load_run(file, {}); }),
              times / 4);
}

TEST_F(MutatedFiles, IncludedStepsAreReadOrRefused) {
    write_campus_of_places_only();
    const int times = support::repeats(600);
    const auto load = [&](const fs::path&) { load_run(folder_.path() / "walks/every-step.walk.yaml", {}); };
    EXPECT_GT(refused("walks/fountain-lap.steps.yaml", times, load), times / 4);
}

TEST_F(MutatedFiles, CampusIsReadOrRefused) {
    const int times = support::repeats(600);
    EXPECT_GT(refused("demo.campus.yaml", times, [](const fs::path& file) { load_campus_description(file); }),
              times / 4);
}

TEST_F(MutatedFiles, AvatarIsReadOrRefused) {
    const int times = support::repeats(3000);
    EXPECT_GT(refused("avatars/adult.avatar.yaml", times, [](const fs::path& file) { load_avatar(file); }),
              times / 4);
}

}  // namespace
}  // namespace campuswalk::config
