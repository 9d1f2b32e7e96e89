#include "engine/render/sequence/animated_png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/render/sequence/scaled_picture.h"
#include "scene/whole_file.h"

namespace campuswalk::engine::render {

AnimatedPng::AnimatedPng(std::filesystem::path file, double seconds_a_frame)
    : file_(std::move(file)),
      milliseconds_(
          static_cast<std::uint16_t>(std::clamp(std::round(1000.0 * seconds_a_frame), 1.0, 65535.0))) {}

void AnimatedPng::add(const Frame& frame) {
    const Picture picture = scaled_down(frame.picture, kAnimationWidth);
    const bool first = !png_;
    if (first) {
        png_ = std::make_unique<PngFile>(picture.width, picture.height);
        control_at_ = png_->size();
        png_->chunk("acTL", {png_number(0), png_number(0)});
    }
    put_control(picture);
    const std::span<const std::uint8_t> pixels = compressor_.compress(picture);
    if (first) {
        png_->chunk("IDAT", {pixels});
    } else {
        png_->chunk("fdAT", {png_number(sequence_++), pixels});
    }
    ++frames_;
}

void AnimatedPng::put_control(const Picture& picture) {
    const std::array<std::uint8_t, 2> delay = {static_cast<std::uint8_t>(milliseconds_ >> 8U),
                                               static_cast<std::uint8_t>(milliseconds_ & 0xFFU)};
    const std::array<std::uint8_t, 2> a_thousand = {1000 >> 8, 1000 & 0xFF};
    const std::array<std::uint8_t, 2> leave_and_replace = {0, 0};
    png_->chunk("fcTL", {png_number(sequence_++), png_number(static_cast<std::uint32_t>(picture.width)),
                         png_number(static_cast<std::uint32_t>(picture.height)), png_number(0), png_number(0),
                         delay, a_thousand, leave_and_replace});
}

void AnimatedPng::finish() {
    if (!png_) {
        return;
    }
    png_->end();
    std::array<std::uint8_t, 8> control{};  // the second number: how often, 0 is for ever
    std::ranges::copy(png_number(frames_), control.begin());
    png_->replace(control_at_, control);
    const std::vector<std::uint8_t> bytes = png_->take();
    scene::write_whole_file(file_, std::as_bytes(std::span(bytes)));
}

}  // namespace campuswalk::engine::render
