#include "engine/html_report/html_reporter.h"

#include <libdeflate.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/html_report/encodings.h"
#include "engine/html_report/walk_row.h"
#include "engine/report/result_json.h"
#include "scene/import/source/decode_image.h"
#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {
namespace {

using Json = nlohmann::json;

constexpr ViewerBundle kViewer = {"show();", "body{margin:0}"};

/// A report as a browser sees it, by the plainest means.
struct Page {
    std::string html;
    std::map<std::string, std::string> chunks;  ///< unpacked, by number

    Json index() const { return Json::parse(chunks.at("index")); }
    Json details(const Json& row) const {
        const std::string& lines = chunks.at(std::to_string(row.at("chunk").get<int>()));
        std::size_t start = 0;
        for (int line = row.at("line").get<int>(); line > 0; --line) {
            start = lines.find('\n', start) + 1;
        }
        return Json::parse(lines.substr(start, lines.find('\n', start) - start));
    }
};

std::string from_base64(const std::string& text) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') {
            break;
        }
        bits = (bits << 6U) | static_cast<unsigned>(kDigits.find(c));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>((bits >> static_cast<unsigned>(count)) & 0xFFU);
        }
    }
    return bytes;
}

std::string gunzipped(const std::string& packed) {
    std::string bytes(packed.size() * 1032 + 1024, '\0');
    libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
    std::size_t size = 0;
    const auto result = libdeflate_gzip_decompress(decompressor, packed.data(), packed.size(), bytes.data(),
                                                   bytes.size(), &size);
    libdeflate_free_decompressor(decompressor);
    EXPECT_EQ(result, LIBDEFLATE_SUCCESS);
    bytes.resize(size);
    return bytes;
}

Page opened(std::string html) {
    Page page{std::move(html), {}};
    const std::string begin = "<script type=\"application/x-campuswalk\" data-chunk=\"";
    for (std::size_t at = page.html.find(begin); at != std::string::npos;
         at = page.html.find(begin, at + 1)) {
        const std::size_t number = at + begin.size();
        const std::size_t quote = page.html.find('"', number);
        const std::size_t text = page.html.find('>', quote) + 1;
        const std::size_t end = page.html.find("</script>", text);
        const bool image = page.html.substr(quote, text - quote).find("data-type") != std::string::npos;
        const std::string bytes = from_base64(page.html.substr(text, end - text));
        page.chunks[page.html.substr(number, quote - number)] = image ? bytes : gunzipped(bytes);
    }
    return page;
}

struct Files {
    std::map<std::string, std::string> artifacts;
    std::map<std::string, std::string> sources;
};

FileReader reader_of(const std::map<std::string, std::string>& files) {
    return [files](const std::string& path) {
        const auto found = files.find(path);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
}

/// As the program's, without a process and limits.
void read_images(const FileReader& read, const std::vector<std::string>& paths,
                 const std::function<void(std::size_t, const scene::PixelView&)>& visit) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::optional<std::string> bytes = read(paths[i]);
        std::string reason;
        const auto image =
            bytes
                ? scene::decode_image(
                      std::span(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()), reason)
                : std::nullopt;
        if (image) {
            visit(i, {image->width, image->height, image->rgba});
        }
    }
}

HtmlInputs inputs_of(const Files& files) {
    HtmlInputs inputs;
    inputs.viewer = kViewer;
    inputs.read_images = read_images;
    inputs.read_artifact = reader_of(files.artifacts);
    inputs.read_source = reader_of(files.sources);
    inputs.campus_file_of = [](const WalkResult&) { return ""; };
    inputs.find_campus = [](const std::string& file) -> std::optional<ReportCampus> {
        if (file != "a.campus.yaml") {
            return std::nullopt;
        }
        return ReportCampus{R"("name":"a","objects":[])", std::string(Gzip(6).pack("glTF bytes")), 0.05};
    };
    return inputs;
}

WalkResult result_named(const std::string& name) {
    WalkResult result;
    result.id = name + ".walk.yaml";
    result.file = result.id;
    result.name = name;
    result.campus = "a";
    result.ticks = 60;
    return result;
}

std::string recording_in(const std::string& campus, int x = 0) {
    return R"({"campuswalk_recording":1,"ticks_per_second":60,"ticks":60,)"
           R"("avatar":{"radius":0.3,"height":1.8,"eye_height":1.7},"campus":{"name":"a","file":")" +
           campus + "\"},\n\"log\":[\n\"000000 x\"\n],\"way\":{\"tick\":[0,60],\"x\":[" + std::to_string(x) +
           R"(,1400],"y":[0,0],"z":[0,0],"yaw":[0,0],"pitch":[0,0],"cut":[0]}})";
}

Page page_of(HtmlInputs inputs, const std::vector<WalkResult>& results, std::size_t planned) {
    std::string html;
    HtmlReporter reporter([&](std::string_view text) { html += text; }, std::move(inputs));
    RunPlan plan;
    plan.cases = planned;
    reporter.begin(plan);
    for (const WalkResult& result : results) {
        reporter.result(result);
    }
    reporter.end(RunReport());
    return opened(std::move(html));
}

TEST(HtmlReporter, HasARowAndTheDetailsOfEachWalk) {
    Files files;
    std::vector<WalkResult> results;
    results.reserve(40);
    for (int i = 0; i < 40; ++i) {
        results.push_back(result_named("walk-" + std::to_string(i)));
    }
    results[7].artifacts = {{"recording", "walk-7/recording.json", "application/json"}};
    files.artifacts["walk-7/recording.json"] = recording_in("a.campus.yaml");
    files.sources["walk-7.walk.yaml"] = "steps: []\n";
    const Page page = page_of(inputs_of(files), results, results.size());
    const Json index = page.index();
    EXPECT_EQ(index.at("complete"), true);
    ASSERT_EQ(index.at("walks").size(), results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Json& row = index["walks"][i];
        EXPECT_EQ(row.at("id"), results[i].id);
        EXPECT_EQ(page.details(row).at("result"), Json::parse(to_json_line(results[i])));
    }
    const Json& row = index["walks"][7];
    EXPECT_EQ(row.at("campus"), 0);
    EXPECT_EQ(row.at("plan"), Json({0, 0, 14, 0}));
    EXPECT_EQ(row.at("seconds"), 1.0);
    EXPECT_EQ(page.details(row).at("recording").at("log")[0], "000000 x");
    EXPECT_EQ(page.details(row).at("source"), Json({{"walk-7.walk.yaml", "steps: []\n"}}));
    EXPECT_EQ(index["walks"][8].at("campus"), -1);
    EXPECT_EQ(page.details(index["walks"][8]).at("recording"), nullptr);
    ASSERT_EQ(index.at("campuses").size(), 1U);
    const Json& geometry = index["campuses"][0].at("geometry");
    EXPECT_EQ(page.chunks.at(std::to_string(geometry.at("chunk").get<int>())), "glTF bytes");
    EXPECT_EQ(geometry.at("kind"), "simplified");
    EXPECT_EQ(geometry.at("error"), 0.05);
}

TEST(HtmlReporter, ChunksAreNumberedInTheFilesOrder) {
    const Page page = page_of(inputs_of({}), std::vector<WalkResult>(100, result_named("a")), 100);
    std::size_t last = 0;
    for (std::size_t i = 0; page.chunks.contains(std::to_string(i)); ++i) {
        const std::size_t at = page.html.find("data-chunk=\"" + std::to_string(i) + "\"");
        EXPECT_GT(at, last);
        last = at;
    }
    EXPECT_GT(page.html.find("data-chunk=\"index\""), last);
    EXPECT_GT(page.html.find("<script>show();</script>"), page.html.find("data-chunk=\"index\""));
}

TEST(HtmlReporter, HostileTextStaysText) {
    const std::string hostile = "</script><img src=x onerror=alert(1)><!--\"'&\xe2\x80\xae \xff";
    WalkResult result = result_named("a");
    result.id = result.file = result.name = result.project = result.status_reason = hostile;
    result.tags = {hostile};
    result.outcome = Outcome::failed;
    result.failures.push_back({{hostile, 1, 1}, hostile, hostile, {}});
    result.artifacts = {{hostile, hostile, hostile}};
    HtmlInputs inputs = inputs_of({});
    inputs.title = hostile;
    inputs.command = hostile;
    inputs.problems = {hostile};
    const Page page = page_of(std::move(inputs), {result}, 1);
    for (const char* markup : {"<img", "onerror=alert(1)><", "<!--\"", "\xff"}) {
        EXPECT_EQ(page.html.find(markup), std::string::npos) << markup;
    }
    EXPECT_NE(page.html.find("<title>&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&lt;!--&quot;'&amp;"),
              std::string::npos);
    const std::string valid = hostile.substr(0, hostile.size() - 1) + "\xef\xbf\xbd";
    EXPECT_EQ(page.index().at("walks")[0].at("id"), valid);
    EXPECT_EQ(page.index().at("title"), valid);
    // Every script element is ours: the data, of which base64 has no angle brackets, and the viewer.
    std::size_t scripts = 0;
    for (std::size_t at = page.html.find("<script"); at != std::string::npos;
         at = page.html.find("<script", at + 1)) {
        ++scripts;
    }
    EXPECT_EQ(scripts, page.chunks.size() + 1);
}

TEST(HtmlReporter, ABundleThatWouldEndItsElementIsRefused) {
    for (const ViewerBundle bundle :
         {ViewerBundle{"a='</script>'", ""}, ViewerBundle{"<!--", ""}, ViewerBundle{"", "</style>"}}) {
        HtmlInputs inputs = inputs_of({});
        inputs.viewer = bundle;
        EXPECT_THROW(HtmlReporter([](std::string_view) {}, std::move(inputs)), std::invalid_argument);
    }
}

TEST(HtmlReporter, SaysWhatIsMissing) {
    HtmlInputs inputs = inputs_of({});
    inputs.problems = {"a.jsonl: error incomplete-report: …"};
    EXPECT_EQ(page_of(std::move(inputs), {result_named("a")}, 1).index().at("complete"), false);
    EXPECT_EQ(page_of(inputs_of({}), {result_named("a")}, 2).index().at("complete"), false);
    EXPECT_EQ(page_of(inputs_of({}), {}, 0).index().at("walks"), Json::array());
}

TEST(HtmlReporter, AThumbnailShowsTheObstacle) {
    const std::string png = from_base64(  // a red pixel
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC");
    Files files;
    WalkResult result = result_named("a");
    for (const char* name : {"shot", "failure-eyes", "failure-beside", "failure-above"}) {
        result.artifacts.push_back({name, std::string("a/") + name + ".png", "image/png"});
        files.artifacts[result.artifacts.back().path] = png;
    }
    const auto thumbnail = [&](Outcome outcome) {
        result.outcome = outcome;
        const Page page = page_of(inputs_of(files), {result}, 1);
        const Json row = page.index().at("walks")[0];
        const Json images = page.details(row).at("pictures");
        for (const auto& [path, chunk] : images.items()) {
            if (chunk == row.at("thumbnail")) {
                return path;
            }
        }
        return std::string("none");
    };
    EXPECT_EQ(thumbnail(Outcome::passed), "a/shot.png");
    EXPECT_EQ(thumbnail(Outcome::failed), "a/failure-beside.png");
}

TEST(HtmlReporter, ARecordingThatIsNoneIsLeftOut) {
    Files files;
    WalkResult result = result_named("a");
    result.artifacts = {{"recording", "a/recording.json", "application/json"}};
    files.artifacts["a/recording.json"] = "{\"campuswalk_recording\":1,";
    const Page page = page_of(inputs_of(files), {result}, 1);
    EXPECT_EQ(page.details(page.index().at("walks")[0]).at("recording"), nullptr);
}

TEST(HtmlReporter, ComparesWithAnotherRun) {
    Files files;
    std::map<std::string, std::string> others;
    std::vector<WalkResult> before;
    std::vector<WalkResult> after;
    for (const char* name : {"same", "way", "verdict", "new"}) {
        WalkResult result = result_named(name);
        result.artifacts = {{"recording", std::string(name) + "/recording.json", "application/json"}};
        files.artifacts[result.artifacts[0].path] = recording_in("a.campus.yaml");
        after.push_back(result);
    }
    before = {after[0], after[1], after[2], result_named("gone")};
    before[1].hash = 7;
    before[2].outcome = Outcome::failed;
    others[before[1].artifacts[0].path] = recording_in("a.campus.yaml", 1400);
    others[before[2].artifacts[0].path] = recording_in("a.campus.yaml");
    HtmlInputs inputs = inputs_of(files);
    ComparedRun against;
    against.name = "main.jsonl";
    against.find = [&](const std::string& id) -> std::optional<WalkResult> {
        const auto found = std::ranges::find(before, id, &WalkResult::id);
        return found == before.end() ? std::nullopt : std::optional(*found);
    };
    against.for_each = [&](const std::function<void(const WalkResult&)>& visit) {
        std::ranges::for_each(before, visit);
    };
    against.read_artifact = reader_of(others);
    inputs.against = against;
    const Page page = page_of(std::move(inputs), after, 4);
    const Json compared = page.index().at("against");
    EXPECT_EQ(compared.at("name"), "main.jsonl");
    ASSERT_EQ(compared.at("walks").size(), 3U);
    EXPECT_EQ(compared["walks"][0].at("name"), "way");
    EXPECT_EQ(compared["walks"][0].at("index"), 1);
    EXPECT_EQ(compared["walks"][0].at("parts_at"), 0);
    EXPECT_EQ(page.details(compared["walks"][0]).at("recording").at("way").at("x")[0], 1400);
    EXPECT_EQ(compared["walks"][1].at("name"), "verdict");
    EXPECT_EQ(compared["walks"][1].at("outcome"), "failed");
    EXPECT_EQ(compared["walks"][1].at("parts_at"), nullptr);
    EXPECT_EQ(compared["walks"][2].at("name"), "gone");
    EXPECT_EQ(compared["walks"][2].at("index"), -1);
    EXPECT_EQ(compared["walks"][2].at("chunk"), -1);
    EXPECT_EQ(compared["walks"][2].at("parts_at"), -1);
}

TEST(HtmlReporter, FindingsGetTheIndexOfTheirCampus) {
    Files files;
    WalkResult result = result_named("a");
    result.artifacts = {{"recording", "a/recording.json", "application/json"}};
    files.artifacts["a/recording.json"] = recording_in("a.campus.yaml");
    HtmlInputs inputs = inputs_of(files);
    inputs.findings = R"([{"campus":"a","kind":"hole"},{"campus":"other","kind":"trap"}])";
    EXPECT_EQ(page_of(std::move(inputs), {result}, 1).index().at("findings"),
              Json::parse(R"([{"campus":0,"kind":"hole"}])"));
}

/// What is held while a report is written doesn't grow with its walks, but for their rows.
TEST(HtmlReporter, HoldsAFewHundredBytesAWalk) {
    std::size_t largest = 0;
    std::size_t whole = 0;
    HtmlReporter reporter(
        [&](std::string_view text) {
            largest = std::max(largest, text.size());
            whole += text.size();
        },
        inputs_of({}));
    reporter.begin({});
    WalkResult result = result_named("a");
    result.failures.push_back({{"a.walk.yaml", 1, 1}, "blocked", std::string(5000, 'x'), {}});
    for (int i = 0; i < 2000; ++i) {
        result.id = result.file = "walks/walk-" + std::to_string(i) + ".walk.yaml";
        reporter.result(result);
    }
    EXPECT_LT(largest, 100'000U) << "chunks are written as they fill";
    EXPECT_LT(open_walk_row(result, {}).size(), 900U);
    reporter.end(RunReport());
}

TEST(Encodings, Base64) {
    const std::map<std::string, std::string> known = {{"", ""},
                                                      {"f", "Zg=="},
                                                      {"fo", "Zm8="},
                                                      {"foo", "Zm9v"},
                                                      {"foob", "Zm9vYg=="},
                                                      {"fooba", "Zm9vYmE="},
                                                      {"foobar", "Zm9vYmFy"}};  // RFC 4648, section 10
    for (const auto& [bytes, text] : known) {
        EXPECT_EQ(base64(bytes), text);
    }
    EXPECT_EQ(base64("\xfb\xff\xfe"), "+//+");
}

std::string random_bytes(std::size_t size) {
    std::mt19937 dice(1);
    std::string bytes(size, '\0');
    std::ranges::generate(bytes, [&] { return static_cast<char>(dice()); });
    return bytes;
}

TEST(Encodings, GzipPacksOneTextAfterTheOther) {
    Gzip gzip(4);
    for (const std::size_t size : {std::size_t{100}, std::size_t{300'000}, std::size_t{10}, std::size_t{0}}) {
        const std::string bytes = random_bytes(size);
        EXPECT_EQ(gunzipped(std::string(gzip.pack(bytes))), bytes);
    }
}

// They are written in pieces.
TEST(HtmlPage, LargeChunksAreWhole) {
    std::string html;
    HtmlPage page([&](std::string_view text) { html += text; }, kViewer);
    page.begin("large");
    std::map<std::string, std::string> added;
    for (const int size : {48 * 1024 - 1, 48 * 1024, 48 * 1024 + 1, 96 * 1024, 300'001}) {
        const std::string bytes = random_bytes(static_cast<std::size_t>(size));
        added[std::to_string(page.add_image(bytes, "image/png"))] = bytes;
    }
    page.finish("{}");
    added["index"] = "{}";
    EXPECT_EQ(opened(html).chunks, added);
}

TEST(Encodings, ShortenedTextHasNoHalfCharacter) {
    EXPECT_EQ(shortened("abc", 10), "abc");
    EXPECT_EQ(shortened("äöüäöü", 8), "äö…");
    EXPECT_EQ(shortened("abcdefghij", 8), "abcde…");
}

}  // namespace
}  // namespace campuswalk::engine
