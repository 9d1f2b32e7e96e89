#include "tools/campuswalk/images/compare_image_files.h"

#include "engine/events/decimals.h"
#include "engine/render/compare/compare_images.h"
#include "engine/render/image/png.h"
#include "engine/render/image/read_png.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/writable_path.h"

namespace campuswalk::tools {

namespace render = engine::render;

namespace {

/// The comparison, which is missing if the sizes differ.
struct Verdict {
    std::optional<render::ImageComparison> comparison;
    std::string why;  ///< how they differ; empty: they are the same
};

std::string size_of(const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

Verdict compare(const render::Image& a, const render::Image& b, const engine::ImageTolerance& tolerance) {
    if (a.width != b.width || a.height != b.height) {
        return {std::nullopt, "one has " + size_of(a) + " pixels, the other " + size_of(b)};
    }
    Verdict verdict;
    verdict.comparison = render::compare_images(a, b, tolerance);
    verdict.why = render::describe_violations(*verdict.comparison, tolerance);
    return verdict;
}

void print_text(const ImgdiffOptions& options, const Verdict& verdict) {
    const std::string names = options.a.string() + " and " + options.b.string();
    if (!verdict.why.empty()) {
        print_line("%s differ: %s", names.c_str(), verdict.why.c_str());
        return;
    }
    print_line("%s are the same: %zu pixels differ, the least similar tile has %s", names.c_str(),
               verdict.comparison->pixels.different,
               engine::fixed(verdict.comparison->worst.ssim, 4).c_str());
}

void print_json(const ImgdiffOptions& options, const render::Image& a, const Verdict& verdict) {
    Json json = {
        {"a", options.a.generic_string()}, {"b", options.b.generic_string()}, {"same", verdict.why.empty()}};
    if (!verdict.why.empty()) {
        json["why"] = verdict.why;
    }
    if (verdict.comparison) {
        const render::TileSimilarity& worst = verdict.comparison->worst;
        json["width"] = a.width;
        json["height"] = a.height;
        json["diff_pixels"] = verdict.comparison->pixels.different;
        json["diff_pixel_ratio"] = verdict.comparison->ratio;
        json["tile_ssim"] = worst.ssim;
        json["worst_tile"] = {worst.box.x, worst.box.y, worst.box.width, worst.box.height};
    }
    print_lines(json_text(json, 2));
}

}  // namespace

int compare_image_files(const ImgdiffOptions& options) {
    if (options.diff) {
        require_writable_png(*options.diff, "the difference can't be drawn here");
        require_no_input(*options.diff, {options.a, options.b}, "is compared");
    }
    const render::Image a = render::read_png(options.a);
    const render::Image b = render::read_png(options.b);
    const Verdict verdict = compare(a, b, options.tolerance);
    if (options.json) {
        print_json(options, a, verdict);
    } else {
        print_text(options, verdict);
    }
    if (options.diff && verdict.comparison) {
        render::write_png(render::draw_difference(a, b, *verdict.comparison, options.tolerance),
                          *options.diff);
    }
    return verdict.why.empty() ? kPass : kDifferent;
}

}  // namespace campuswalk::tools
