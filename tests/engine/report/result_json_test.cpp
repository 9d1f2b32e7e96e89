#include "engine/report/result_json.h"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/engine/report/some_results.h"
#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

WalkResult round_trip(const WalkResult& result) {
    return result_from_json_line(to_json_line(result));
}

/// The error in a line; empty if there is none.
std::string error_of(const std::string& line) {
    try {
        result_from_json_line(line);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(ResultJson, RoundTripsEveryField) {
    const WalkResult result = full_result();
    const WalkResult back = round_trip(result);
    EXPECT_EQ(back.id, result.id);
    EXPECT_EQ(back.file, result.file);
    EXPECT_EQ(back.name, result.name);
    EXPECT_EQ(back.project, result.project);
    EXPECT_EQ(back.config, result.config);
    EXPECT_EQ(back.repetition, result.repetition);
    EXPECT_EQ(back.tags, result.tags);
    EXPECT_EQ(back.status_reason, result.status_reason);
    EXPECT_EQ(back.expected_to_fail, result.expected_to_fail);
    EXPECT_EQ(back.outcome, result.outcome);
    EXPECT_EQ(back.diagnostics, result.diagnostics);
    EXPECT_EQ(back.campus, result.campus);
    EXPECT_EQ(back.ticks_per_second, result.ticks_per_second);
    EXPECT_EQ(back.timeout, result.timeout);
    EXPECT_EQ(round_trip(passed_result("quick")).timeout, std::nullopt);
    EXPECT_EQ(back.ticks, result.ticks);
    EXPECT_EQ(back.events, result.events);
    EXPECT_EQ(back.distance, result.distance);
    EXPECT_EQ(back.hash, result.hash);
    ASSERT_EQ(back.artifacts.size(), 1U);
    EXPECT_EQ(back.artifacts[0].name, result.artifacts[0].name);
    EXPECT_EQ(back.artifacts[0].path, result.artifacts[0].path);
    EXPECT_EQ(back.artifacts[0].media_type, result.artifacts[0].media_type);
}

TEST(ResultJson, RoundTripsEveryFieldOfAFailure) {
    const WalkResult result = full_result();
    const WalkResult back = round_trip(result);
    ASSERT_EQ(back.failures.size(), 1U);
    const Failure& was = result.failures[0];
    const Failure& is = back.failures[0];
    EXPECT_EQ(is.mark.file, was.mark.file);
    EXPECT_EQ(is.mark.line, was.mark.line);
    EXPECT_EQ(is.mark.column, was.mark.column);
    EXPECT_EQ(is.code, was.code);
    EXPECT_EQ(is.message, was.message);
    EXPECT_EQ(is.scene.tick, was.scene.tick);
    EXPECT_EQ(is.scene.time, was.scene.time);
    EXPECT_EQ(is.scene.position, was.scene.position);
    EXPECT_EQ(is.scene.yaw, was.scene.yaw);
    EXPECT_EQ(is.scene.pitch, was.scene.pitch);
    EXPECT_EQ(is.scene.building, was.scene.building);
    EXPECT_EQ(is.scene.nearest, was.scene.nearest);
    EXPECT_EQ(is.scene.nearest_distance, was.scene.nearest_distance);
    EXPECT_EQ(is.scene.contact, was.scene.contact);
    EXPECT_EQ(is.scene.last_events, was.scene.last_events);
    EXPECT_EQ(is.object, was.object);
    EXPECT_EQ(is.route, was.route);
    EXPECT_EQ(is.actual, was.actual);
    EXPECT_EQ(is.expected, was.expected);
}

TEST(ResultJson, RoundTripsReasonsOfEveryKind) {
    WalkResult result = full_result();
    EXPECT_EQ(round_trip(result).failures[0].reason, result.failures[0].reason);
    for (const ReasonKind kind : reason_kinds()) {
        result.failures[0].reason = Reason{.kind = kind, .measured = 1.0 / 7.0, .allowed = 0.3};
        EXPECT_EQ(round_trip(result).failures[0].reason, result.failures[0].reason) << name_of(kind);
    }
    result.failures[0].reason.reset();
    EXPECT_EQ(to_json_line(result).find("\"reason\""), std::string::npos);
}

TEST(ResultJson, RoundTripsTheBitsOfEveryDouble) {
    support::Dice dice(7);
    std::vector<double> values = {0.0,
                                  -0.0,
                                  0.1,
                                  1.0 / 3.0,
                                  -1e308,
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::min(),
                                  std::numeric_limits<double>::max(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 2000; ++i) {
        values.push_back(std::ldexp(dice.between(-1.0, 1.0), dice.below(400) - 200));
    }
    for (const double value : values) {
        WalkResult result;
        result.distance = value;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(round_trip(result).distance),
                  std::bit_cast<std::uint64_t>(value))
            << value;
    }
    WalkResult result;
    result.distance = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(round_trip(result).distance));
}

TEST(ResultJson, RoundTripsTheLargestAndSmallestIntegers) {
    WalkResult result;
    result.hash = std::numeric_limits<std::uint64_t>::max();
    result.ticks = std::numeric_limits<Tick>::max();
    result.events = std::numeric_limits<std::int64_t>::min();
    result.repetition = std::numeric_limits<int>::max();
    const WalkResult back = round_trip(result);
    EXPECT_EQ(back.hash, result.hash);
    EXPECT_EQ(back.ticks, result.ticks);
    EXPECT_EQ(back.events, result.events);
    EXPECT_EQ(back.repetition, result.repetition);
}

TEST(ResultJson, IsOneLineForAnyText) {
    WalkResult result;
    for (int c = 0; c < 0x80; ++c) {
        result.name += static_cast<char>(c);
    }
    result.name += "Überbau – 図書館 \u2028 \U0001F6B6";
    const std::string line = to_json_line(result);
    EXPECT_EQ(line.find_first_of("\n\r"), std::string::npos);
    EXPECT_EQ(round_trip(result).name, result.name);
}

TEST(ResultJson, ReplacesBytesThatAreNotUtf8) {
    WalkResult result;
    result.file = "caf\xe9/\xff.walk.yaml";
    const WalkResult back = round_trip(result);
    EXPECT_EQ(back.file, "caf\xEF\xBF\xBD/\xEF\xBF\xBD.walk.yaml");
    EXPECT_EQ(to_json_line(back), to_json_line(result));
}

TEST(ResultJson, RoundTripsEveryOutcome) {
    for (const Outcome outcome : {Outcome::passed, Outcome::failed, Outcome::skipped, Outcome::bad_input,
                                  Outcome::broken, Outcome::interrupted}) {
        WalkResult result;
        result.outcome = outcome;
        EXPECT_EQ(round_trip(result).outcome, outcome);
    }
}

TEST(ResultJson, RejectsAMissingFieldAndNamesIt) {
    const Json whole = Json::parse(to_json_line(full_result()));
    for (const auto& [name, value] : whole.items()) {
        Json less = whole;
        less.erase(name);
        EXPECT_THAT(error_of(less.dump()), ContainsRegex("(^|[^a-z_])" + name + "([^a-z_]|$)"));
    }
    Json less = whole;
    less["failures"][0]["scene"].erase("tick");
    EXPECT_THAT(error_of(less.dump()), HasSubstr("failures[0].scene.tick"));
}

TEST(ResultJson, RejectsUnknownAndRepeatedFields) {
    Json more = Json::parse(to_json_line(full_result()));
    more["artifacts"][0]["size"] = 3;
    EXPECT_THAT(error_of(more.dump()), HasSubstr("artifacts[0].size"));
    const std::string line = to_json_line(full_result());
    EXPECT_THAT(error_of(R"({"name":"b",)" + line.substr(1)), HasSubstr("name"));
}

TEST(ResultJson, RejectsADiagnosticOfAnUnknownCode) {
    std::string line = to_json_line(bad_input_result("typo"));
    const std::string code = "\"bad-value\"";
    const std::size_t at = line.find(code);
    ASSERT_NE(at, std::string::npos) << line;
    line.replace(at, code.size(), "\"bad-word\"");
    EXPECT_THAT(error_of(line), HasSubstr("must be the code of a diagnostic"));
}

TEST(ResultJson, RejectsFieldsOfTheWrongType) {
    const Json whole = Json::parse(to_json_line(full_result()));
    for (const auto& [name, value] : whole.items()) {
        for (const Json& other :
             {Json(nullptr), Json(true), Json("x"), Json(1.5), Json::object(), Json(Json::array({Json()}))}) {
            if (other.type() == value.type() && name != "hash" && name != "outcome" && !value.is_array()) {
                continue;
            }
            if (name == "timeout" && other.is_null()) {
                continue;  // null is no timeout
            }
            Json wrong = whole;
            wrong[name] = other;
            EXPECT_NE(error_of(wrong.dump()).find(name), std::string::npos) << name << " " << other;
        }
    }
}

TEST(ResultJson, RejectsAnyDepthOfNesting) {
    const std::string deep(1'000'000, '[');
    EXPECT_THAT(error_of(R"({"id":)" + deep + std::string(deep.size(), ']') + "}"),
                HasSubstr("nested deeply"));
    EXPECT_THAT(error_of(R"({"id":)" + deep), HasSubstr("nested deeply"));
}

TEST(ResultJson, RoundTripsAPlan) {
    const RunPlan plan{.cases = 4,
                       .shard = 2,
                       .shards = 3,
                       .all_cases = 11,
                       .contents = "0a",
                       .division = "1b",
                       .fingerprint = {"0.1.0", "2c", "3d"},
                       .start = "campus"};
    const std::string line = to_header_line(plan);
    const std::optional<RunPlan> back = plan_from_header_line(line);
    ASSERT_TRUE(back);
    EXPECT_EQ(to_header_line(*back), line);
    EXPECT_EQ(back->shard, 2);
    EXPECT_EQ(back->all_cases, 11U);
    EXPECT_EQ(back->fingerprint, plan.fingerprint);
}

TEST(ResultJson, TellsOtherFilesFromDamagedHeaders) {
    for (const std::string& other : {std::string(), std::string("{"), std::string("[1]"), std::string("{}"),
                                     to_json_line(passed_result("quick"))}) {
        EXPECT_FALSE(plan_from_header_line(other)) << other;
    }
    const Json whole = Json::parse(to_header_line({}));
    for (const auto& [name, value] : whole.items()) {
        if (name != "campuswalk_results") {
            Json less = whole;
            less.erase(name);
            EXPECT_THROW(plan_from_header_line(less.dump()), std::runtime_error) << name;
        }
    }
    EXPECT_THROW(plan_from_header_line(R"({"campuswalk_results":1,"cases":9})"), std::runtime_error);
}

TEST(ResultJson, RejectsNumbersOutOfRange) {
    const auto with = [](const char* name, const Json& value) {
        Json json = Json::parse(to_json_line(full_result()));
        json[name] = value;
        return error_of(json.dump());
    };
    EXPECT_THAT(with("repetition", 2147483648), AllOf(HasSubstr("repetition"), HasSubstr("2147483648")));
    EXPECT_THAT(with("ticks", 9223372036854775808U),
                AllOf(HasSubstr("ticks"), HasSubstr("9223372036854775808")));
    EXPECT_THAT(with("not_evaluated", 4294967296), AllOf(HasSubstr("not_evaluated"), HasSubstr("4294967296")))
        << "the sum of some must not overflow to 0";
    EXPECT_THAT(with("not_evaluated", -1), AllOf(HasSubstr("not_evaluated"), HasSubstr("-1")));
    EXPECT_THAT(with("hash", "0x00000000000000"),
                AllOf(HasSubstr("hash"), HasSubstr("\"0x00000000000000\"")));
    EXPECT_THAT(with("hash", "abc"), AllOf(HasSubstr("hash"), HasSubstr("\"abc\"")));
}

TEST(ResultJson, RejectsTruncatedLines) {
    const std::string line = to_json_line(full_result());
    for (std::size_t length = 0; length < line.size(); ++length) {
        ASSERT_NE(error_of(line.substr(0, length)), "") << length;
    }
    EXPECT_NE(error_of(line + "}"), "");
    EXPECT_NE(error_of(std::string(100000, '[')), "");
    EXPECT_THAT(error_of("[]"), HasSubstr("a list"));
}

}  // namespace
}  // namespace campuswalk::engine
