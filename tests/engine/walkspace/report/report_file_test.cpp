// Cached reports: they come back whole, and damaged ones don't.

#include "engine/walkspace/report/report_file.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/base/binary_archive.h"
#include "scene/base/checksum.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/dice.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

/// Of a floor with a pit, something to climb, and a shelf that nobody gets to: all but empty lists.
struct Reported {
    scene::Campus campus;
    ExploreSettings settings;
    WalkReport report;
};

WalkReport report_on(const scene::Campus& campus, const ExploreSettings& settings) {
    const WorkerWorlds worlds(campus.world, 1, WorkerWorlds::MakeBroadPhase());
    return report_walks(campus, AvatarProfile(), worlds, settings, 1.2);
}

Reported reported() {
    scene::Campus campus = varied_ground();
    campus.description.places.push_back({{}, "shelf", {-6, 0.9, 4.5}});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {kOnVariedGround};
    WalkReport report = report_on(campus, settings);
    return {std::move(campus), settings, std::move(report)};
}

/// Corrects the length and the checksum, as a forger would.
void forge(std::vector<std::byte>& bytes) {
    const std::uint64_t size = bytes.size() - scene::kArchiveHeaderBytes;
    const std::uint64_t checksum =
        scene::checksum_of(std::span<const std::byte>(bytes).subspan(scene::kArchiveHeaderBytes));
    std::memcpy(bytes.data() + 16, &size, sizeof size);
    std::memcpy(bytes.data() + 24, &checksum, sizeof checksum);
}

/// Follows what the report refers to, for sanitizers.
void follow(const WalkReport& report) {
    std::size_t links = 0;
    for (const WalkNodeId& node : nodes_of(report.space)) {
        EXPECT_LT(report.storeys.of(node), report.storeys.list.size());
        for (auto at = report.space.parent(node); at; at = report.space.parent(*at)) {
            ++links;
        }
    }
    EXPECT_GT(links, 0U);
}

TEST(ReportFile, BringsBackWhatWasWritten) {
    const Reported was = reported();
    ASSERT_FALSE(was.report.islands.empty());
    ASSERT_FALSE(was.report.holes.empty());
    ASSERT_TRUE(std::ranges::any_of(was.report.islands,
                                    [](const IslandReport& entry) { return entry.barrier.has_value(); }));
    const std::vector<std::byte> bytes = archive_report(was.report);
    const WalkReport read = read_report_file(bytes, was.campus.objects.size());

    EXPECT_EQ(archive_report(read), bytes);
    EXPECT_EQ(read.space.node_count(), was.report.space.node_count());
    EXPECT_EQ(read.space.area(), was.report.space.area());
    ASSERT_EQ(read.subjects.size(), was.report.subjects.size());
    for (std::size_t i = 0; i < read.subjects.size(); ++i) {
        EXPECT_EQ(read.subjects[i].subject.name, was.report.subjects[i].subject.name);
        EXPECT_EQ(read.subjects[i].subject.reached, was.report.subjects[i].subject.reached);
        EXPECT_EQ(read.subjects[i].distance, was.report.subjects[i].distance);
    }
}

TEST(ReportFile, BringsBackWhateverItHoldsOfAKind) {
    Reported was = reported();
    ASSERT_FALSE(was.report.subjects.empty());
    const auto subject = was.report.subjects.front();
    was.report.space.bounds.clear();
    for (std::size_t i = 0; i < kBoundNames.size(); ++i) {
        was.report.space.bounds.push_back(static_cast<Bound>(i));
    }
    for (std::size_t i = 0; i < kSubjectKindNames.size(); ++i) {
        was.report.subjects.push_back(subject);
        was.report.subjects.back().subject.kind = static_cast<SubjectKind>(i);
    }
    for (const ReasonKind kind : reason_kinds()) {
        was.report.subjects.push_back(subject);
        was.report.subjects.back().subject.reason = Reason{.kind = kind};
    }
    const std::vector<std::byte> bytes = archive_report(was.report);
    EXPECT_EQ(archive_report(read_report_file(bytes, was.campus.objects.size())), bytes);
}

TEST(ReportFile, KeepsTheChains) {
    const Reported was = reported();
    const WalkReport read = read_report_file(archive_report(was.report), was.campus.objects.size());
    Strider strider(was.campus.world, was.settings.strides, was.settings.solids);
    for (const WalkNodeId& node : some_nodes(was.report.space, 40)) {
        EXPECT_EQ(read.space.find(read.space.cell_of(node), static_cast<double>(read.space.node(node).y)),
                  node);
        EXPECT_EQ(read.space.chain(node, strider).back().at, was.report.space.chain(node, strider).back().at);
    }
}

TEST(ReportFile, IsOfOneCampus) {
    const Reported was = reported();
    EXPECT_THROW(read_report_file(archive_report(was.report), was.campus.objects.size() + 1),
                 scene::DamagedFile);
}

TEST(ReportFile, IsRejectedWhenTruncated) {
    const Reported was = reported();
    const std::vector<std::byte> bytes = archive_report(was.report);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97) {
        std::vector<std::byte> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_THROW(read_report_file(part, was.campus.objects.size()), scene::DamagedFile);
        if (size >= scene::kArchiveHeaderBytes) {
            forge(part);
            EXPECT_THROW(read_report_file(part, was.campus.objects.size()), scene::DamagedFile);
        }
    }
}

/// With a valid checksum: what is accepted can be followed.
TEST(ReportFile, IsRejectedOrSafeToFollowWhenForged) {
    const Reported was = reported();
    const std::vector<std::byte> whole = archive_report(was.report);
    support::Dice dice(7);
    int rejected = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<std::byte> bytes = whole;
        const auto payload = static_cast<int>(bytes.size() - scene::kArchiveHeaderBytes);
        const std::size_t at = scene::kArchiveHeaderBytes + static_cast<std::size_t>(dice.below(payload));
        bytes[at] = static_cast<std::byte>(dice.below(256));
        forge(bytes);
        try {
            follow(read_report_file(bytes, was.campus.objects.size()));
        } catch (const scene::DamagedFile&) {
            ++rejected;
        }
    }
    EXPECT_GT(rejected, 20);
}

TEST(ReportFile, IsRejectedWhenItsChainsGoInACircle) {
    Reported was = reported();
    WalkTile& tile = was.report.space.tiles.front();
    for (std::uint16_t n = 0; n < 2; ++n) {
        tile.nodes[n].parent_tile = 4;
        tile.nodes[n].parent = static_cast<std::uint16_t>(1 - n);
    }
    EXPECT_THROW(read_report_file(archive_report(was.report), was.campus.objects.size()), scene::DamagedFile);
}

/// Cells and their neighbours are numbered by `int`.
TEST(ReportFile, IsRejectedWhenItsGroundIsTooFarAway) {
    Reported was = reported();
    was.report.space.tiles.front().first_cell = {2'147'483'632, 0};
    EXPECT_THROW(read_report_file(archive_report(was.report), was.campus.objects.size()), scene::DamagedFile);
    Reported other = reported();
    other.report.holes.front().edges.front().at.x() = 1e12;
    EXPECT_THROW(read_report_file(archive_report(other.report), other.campus.objects.size()),
                 scene::DamagedFile);
}

/// The bodies of files that the fuzzer begins with. Whenever the format changes, they are to be written anew:
/// `campuswalk explore --min-width 1` keeps them in its cache, behind a header.
TEST(ReportFile, FuzzersSeedsAreStillReadable) {
    std::size_t seeds = 0;
    const std::filesystem::path folder = CAMPUSWALK_SOURCE_DIR "/tests/fuzz/corpus/walk-space";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::vector<std::byte> bytes = archive_report(reported().report);
        bytes.resize(scene::kArchiveHeaderBytes);
        std::ifstream file(entry.path(), std::ios::binary);
        for (char c = 0; file.get(c);) {
            bytes.push_back(static_cast<std::byte>(c));
        }
        forge(bytes);
        follow(read_report_file(bytes, 3));
        ++seeds;
    }
    EXPECT_GE(seeds, 2U);
}

}  // namespace
}  // namespace campuswalk::engine
