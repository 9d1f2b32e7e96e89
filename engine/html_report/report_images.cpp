#include "engine/html_report/report_images.h"

namespace campuswalk::engine {

namespace {

constexpr int kMaxWidth = 1280;    // pixels
constexpr int kMaxHeight = 16383;  // pixels, WebP's own limit
constexpr float kQuality = 80.0F;  // of 100

bool is_compared(const Artifact& artifact) {
    const std::string& path = artifact.path;
    return path.ends_with("-actual.png") || path.ends_with("-expected.png") || path.ends_with("-diff.png");
}

}  // namespace

bool is_still_image(const Artifact& artifact) {
    return artifact.media_type == "image/png";
}

ReportImage report_image(const Artifact& artifact, const scene::PixelView& pixels) {
    if (is_compared(artifact)) {
        const scene::Pixels whole = scene::shrunk_to_fit(pixels, kMaxHeight, kMaxHeight);
        return {scene::encode_webp_lossless(whole.view()), "image/webp"};
    }
    const scene::Pixels shown = scene::shrunk_to_fit(pixels, kMaxWidth, kMaxHeight);
    return {scene::encode_webp(shown.view(), kQuality), "image/webp"};
}

}  // namespace campuswalk::engine
