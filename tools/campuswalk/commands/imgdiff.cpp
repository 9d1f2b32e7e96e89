#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/images/compare_image_files.h"

namespace campuswalk::tools {

namespace {

constexpr Limits<double> kShare{0.0, 1.0};
constexpr Limits<double> kSimilarity{-1.0, 1.0};
constexpr Limits<int> kPixels{0, 1'000'000'000};

/// X,Y,WIDTH,HEIGHT as whole numbers; nullopt for anything else.
std::optional<engine::PixelBox> parse_mask(const std::string& text) {
    std::array<int, 4> numbers{};
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != numbers.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const char* end = parts[i].data() + parts[i].size();
        const auto [rest, error] = std::from_chars(parts[i].data(), end, numbers[i]);
        if (error != std::errc() || rest != end || numbers[i] < 0 || numbers[i] > kPixels.max) {
            return std::nullopt;
        }
    }
    return engine::PixelBox{numbers[0], numbers[1], numbers[2], numbers[3]};
}

/// The options as they are written on the command line.
struct ImgdiffArguments {
    ImgdiffOptions options;
    std::vector<std::string> masks;
};

void add_tolerance(Command& command, ImgdiffArguments& arguments) {
    engine::ImageTolerance& tolerance = arguments.options.tolerance;
    command.option(
        {.names = "--threshold",
         .help =
             "Colours that differ by no more than this count as equal: 0 is identical, 1 accepts anything",
         .value = "0..1",
         .show_default = true},
        tolerance.threshold, kShare);
    command.option({.names = "--max-diff-pixels",
                    .help = "How many pixels may differ by more [0, unless there is a ratio]",
                    .value = "N"},
                   tolerance.max_diff_pixels, kPixels);
    command.option(
        {.names = "--max-diff-pixel-ratio", .help = "The same as a share of all pixels", .value = "0..1"},
        tolerance.max_diff_pixel_ratio, kShare);
    command.option({.names = "--min-tile-ssim",
                    .help = "The structural similarity that each tile of 64 pixels needs; -1 for none",
                    .value = "-1..1",
                    .show_default = true},
                   tolerance.min_tile_ssim, kSimilarity);
    command.option({.names = "--mask",
                    .help = "Ignore this rectangle; may be repeated",
                    .value = "X,Y,W,H",
                    .check =
                        [](const std::string& text) {
                            return parse_mask(text) ? std::string()
                                                    : "'" + text + "' isn't X,Y,WIDTH,HEIGHT in whole pixels";
                        }},
                   arguments.masks);
}

}  // namespace

void add_imgdiff(Command program, CommandAction& chosen) {
    const auto arguments = std::make_shared<ImgdiffArguments>();
    ImgdiffOptions& options = arguments->options;
    Command command = program.add("imgdiff", "Compare two pictures");
    command.option({.names = "A", .help = "A PNG file", .value = "FILE", .required = true}, options.a);
    command.option(
        {.names = "B", .help = "The PNG file to compare with it", .value = "FILE", .required = true},
        options.b);
    add_tolerance(command, *arguments);
    command.option(
        {.names = "--diff",
         .help = "Draw where they differ: red what is beyond the threshold, orange what is within, "
                 "yellow what is smoothed otherwise, magenta frames around tiles not alike enough",
         .value = "FILE"},
        options.diff);
    command.flag({.names = "--json", .help = "Print JSON"}, options.json);
    command.footer(
        "Colours are compared as pixelmatch does it, with the weights of the eye; structure by the SSIM of\n"
        "brightness. Either finds what the other doesn't. The defaults allow for another processor.\n"
        "Exit code: 0 the same, 1 different or of different sizes, 2 bad usage or input.");
    command.choose(chosen, [arguments] {
        ImgdiffOptions chosen_options = arguments->options;
        for (const std::string& mask : arguments->masks) {
            chosen_options.tolerance.masks.push_back(parse_mask(mask).value_or(engine::PixelBox{}));
        }
        return compare_image_files(chosen_options);
    });
}

}  // namespace campuswalk::tools
