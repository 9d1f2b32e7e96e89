#include "tools/campuswalk_bench/draw/draw_report.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "engine/events/decimals.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::tools::bench {

namespace {

const DrawTimes* find(const DrawnCampus& campus, const std::string& engine, const std::string& look) {
    const auto found = std::find_if(campus.looks.begin(), campus.looks.end(), [&](const DrawTimes& times) {
        return times.engine == engine && times.look == look;
    });
    return found == campus.looks.end() ? nullptr : &*found;
}

/// How many times as long as ours the engine takes for the same look.
std::optional<double> times_ours(const DrawnCampus& campus, const std::string& engine,
                                 const std::string& look, const char* our_engine = kOurs) {
    const DrawTimes* ours = find(campus, our_engine, look);
    const DrawTimes* theirs = find(campus, engine, look);
    if (ours == nullptr || theirs == nullptr) {
        return std::nullopt;
    }
    return median_ms(*theirs) / median_ms(*ours);
}

std::optional<double> ours_ms(const DrawnCampus& campus, const std::string& look, const char* our_engine) {
    const DrawTimes* ours = find(campus, our_engine, look);
    return ours == nullptr ? std::nullopt : std::optional(median_ms(*ours));
}

/// The longest allowed times of an image of a campus of at most `max_triangles`.
struct Allowance {
    std::size_t max_triangles = 0;
    double fxaa_ms = 0.0;
    double msaa_ms = 0.0;
};
constexpr Allowance kAllowances[] = {{1000000, 50.0, 110.0}, {4000000, 85.0, 187.0}};

void add_time_verdicts(const DrawnCampus& campus, const char* our_engine, std::vector<Verdict>& verdicts) {
    const std::string of = ", " + campus.name + " of " + std::to_string(campus.triangles) + " triangles" +
                           (our_engine == std::string_view(kOurProcesses) ? ", by processes" : "");
    const auto* allowed = std::find_if(std::begin(kAllowances), std::end(kAllowances), [&](const auto& each) {
        return campus.triangles <= each.max_triangles;
    });
    if (allowed != std::end(kAllowances)) {
        verdicts.push_back(at_most("an image, shadows+fxaa" + of, ours_ms(campus, "shadows+fxaa", our_engine),
                                   " ms", allowed->fxaa_ms));
        verdicts.push_back(at_most("an image, shadows+msaa4" + of,
                                   ours_ms(campus, "shadows+msaa4", our_engine), " ms", allowed->msaa_ms));
    }
    for (const char* look : {"no-aa", "fxaa", "msaa4", "shadows+fxaa", "shadows+msaa4"}) {
        verdicts.push_back(at_least(look + of, times_ours(campus, "three.js", look, our_engine),
                                    "x as long in three.js", 2.0, 4.0));
    }
    for (const char* look : {"no-aa", "fxaa", "msaa4"}) {
        verdicts.push_back(
            at_least(look + of, times_ours(campus, "vtk", look, our_engine), "x as long in VTK", 3.0));
    }
}

}  // namespace

void print_draw_table(const DrawnCampus& campus) {
    std::printf("%-12s%-16s%9s%9s%9s%9s%12s\n", "", "ms per image", "median", "mean", "least", "cpu",
                "times ours");
    for (const DrawTimes& times : campus.looks) {
        std::printf("%-12s%-16s%9.1f%9.1f%9.1f", times.engine.c_str(), times.look.c_str(), median_ms(times),
                    mean_ms(times), least_ms(times));
        std::printf("%9s", times.cpu_ms ? engine::fixed(*times.cpu_ms, 1).c_str() : "");
        const auto ratio = times_ours(campus, times.engine, times.look);
        if (times.engine != kOurs && ratio) {
            std::printf("%11.2fx", *ratio);
        }
        std::printf("\n");
    }
    std::printf("PNG of an image: %.1f ms; memory of the default look, with textures and maps: %.1f MB\n",
                campus.encode_ms, 1e-6 * static_cast<double>(campus.heap_bytes));
}

std::vector<Verdict> draw_verdicts(const std::vector<DrawnCampus>& campuses) {
    std::vector<Verdict> verdicts;
    for (const DrawnCampus& campus : campuses) {
        add_time_verdicts(campus, kOurs, verdicts);
        add_time_verdicts(campus, kOurProcesses, verdicts);
    }
    if (campuses.empty()) {
        return verdicts;
    }
    const DrawnCampus& small = campuses.front();
    const DrawnCampus& large = campuses.back();
    std::optional<double> bytes;
    if (large.triangles > small.triangles && small.heap_bytes > 0) {
        bytes = (static_cast<double>(large.heap_bytes) - static_cast<double>(small.heap_bytes)) /
                static_cast<double>(large.triangles - small.triangles);
    }
    verdicts.push_back(at_most("memory per triangle, without textures", bytes, " bytes", 200.0));
    verdicts.push_back(at_most("PNG of an image", large.encode_ms, " ms", 20.0));
    return verdicts;
}

void print_draw_verdicts(const std::vector<Verdict>& verdicts) {
    std::printf("\nCompared with the targets, by medians\n");
    print_verdicts(verdicts, 68,
                   [](const Verdict& verdict) { std::printf("%8.2f%-24s", *verdict.value, verdict.unit); });
}

void write_draw_csv(const std::vector<DrawnCampus>& campuses, const std::filesystem::path& file) {
    std::string text = "campus,triangles,engine,look,ms_median,ms_mean,ms_least,ms_cpu,times_ours\n";
    for (const DrawnCampus& campus : campuses) {
        for (const DrawTimes& times : campus.looks) {
            const auto ratio = times_ours(campus, times.engine, times.look);
            text += campus.name + ',' + std::to_string(campus.triangles) + ',' + times.engine + ',' +
                    times.look + ',' + engine::fixed(median_ms(times), 2) + ',' +
                    engine::fixed(mean_ms(times), 2) + ',' + engine::fixed(least_ms(times), 2) + ',' +
                    (times.cpu_ms ? engine::fixed(*times.cpu_ms, 2) : "") + ',' +
                    (ratio ? engine::fixed(*ratio, 3) : "") + '\n';
        }
    }
    scene::write_file_atomically(file, text);
}

}  // namespace campuswalk::tools::bench
