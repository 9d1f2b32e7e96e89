#include "engine/render/sequence/animated_png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/render/sequence/scaled_image.h"

namespace campuswalk::engine::render {

AnimatedPng::AnimatedPng(std::filesystem::path file, double seconds_per_frame)
    : file_(std::move(file)),
      milliseconds_(
          static_cast<std::uint16_t>(std::clamp(std::round(1000.0 * seconds_per_frame), 1.0, 65535.0))) {}

void AnimatedPng::add(const Frame& frame) {
    const Image image = scaled_down(frame.image, kAnimationWidth);
    const bool first = !png_;
    if (first) {
        written_ = std::make_unique<scene::AtomicFile>(file_);
        png_ = std::make_unique<PngWriter>(image.width, image.height);
        const std::vector<std::uint8_t> start = png_->take();
        written_->write(std::as_bytes(std::span(start)));
        count_at_ = start.size();
        put_count(0);  // placeholder until finish
    }
    put_control(image);
    const std::span<const std::uint8_t> pixels = compressor_.compress(image);
    if (first) {
        png_->chunk("IDAT", {pixels});
    } else {
        png_->chunk("fdAT", {png_uint32(sequence_++), pixels});
    }
    written_->write(std::as_bytes(std::span<const std::uint8_t>(png_->take())));
    ++frames_;
}

// The second value is the number of plays; 0 loops.
void AnimatedPng::put_count(std::uint32_t frames) {
    png_->chunk("acTL", {png_uint32(frames), png_uint32(0)});
}

void AnimatedPng::put_control(const Image& image) {
    const std::array<std::uint8_t, 2> delay = {static_cast<std::uint8_t>(milliseconds_ >> 8U),
                                               static_cast<std::uint8_t>(milliseconds_ & 0xFFU)};
    const std::array<std::uint8_t, 2> per_second = {1000 >> 8, 1000 & 0xFF};
    const std::array<std::uint8_t, 2> no_disposal_no_blending = {0, 0};
    png_->chunk("fcTL", {png_uint32(sequence_++), png_uint32(static_cast<std::uint32_t>(image.width)),
                         png_uint32(static_cast<std::uint32_t>(image.height)), png_uint32(0), png_uint32(0),
                         delay, per_second, no_disposal_no_blending});
}

void AnimatedPng::finish() {
    if (!png_) {
        return;
    }
    png_->end();
    written_->write(std::as_bytes(std::span<const std::uint8_t>(png_->take())));
    put_count(frames_);
    written_->replace(count_at_, std::as_bytes(std::span<const std::uint8_t>(png_->take())));
    written_->finish();
}

}  // namespace campuswalk::engine::render
