#include "engine/render/sequence/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/render/image/png.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/sequence/scaled_image.h"

namespace campuswalk::engine::render {
namespace {

constexpr int kThumbnail = 240;  // pixels wide
constexpr int kGap = 8;          // pixels, between and around them
constexpr int kMaxColumns = 10;
constexpr std::uint8_t kBackground = 0x24;
constexpr double kTextSize = 12.0;

/// The number of columns that gives a sheet of about screen proportions.
int columns_for(std::size_t frames, const Image& thumbnail) {
    const double shape = 1.6 * thumbnail.height / thumbnail.width;
    const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(frames) * shape)));
    return std::clamp(columns, 1, std::min(kMaxColumns, static_cast<int>(frames)));
}

void copy_into(Image& sheet, const Image& image, int left, int top) {
    for (int y = 0; y < image.height; ++y) {
        const auto* row = &image.rgba[image.offset(0, y)];
        std::copy(row, row + std::ptrdiff_t{4} * image.width, &sheet.rgba[sheet.offset(left, top + y)]);
    }
}

}  // namespace

ContactSheet::ContactSheet(std::filesystem::path file) : file_(std::move(file)) {}

void ContactSheet::add(const Frame& frame) {
    if (frame.number % every_ != 0) {
        return;
    }
    frames_.push_back({scaled_down(frame.image, kThumbnail), frame.number, frame.time});
    if (frames_.size() > kMaxFrames) {
        every_ *= 2;
        std::erase_if(frames_, [this](const Frame& other) { return other.number % every_ != 0; });
    }
}

void ContactSheet::finish() {
    if (!frames_.empty()) {
        write_png(sheet(), file_);
    }
}

Image ContactSheet::sheet() const {
    const Image& first = frames_.front().image;
    const int columns = columns_for(frames_.size(), first);
    const int rows = (static_cast<int>(frames_.size()) + columns - 1) / columns;
    Image sheet = Image::filled(columns * (first.width + kGap) + kGap, rows * (first.height + kGap) + kGap,
                                kBackground);
    const auto left = [&](std::size_t i) {
        return kGap + static_cast<int>(i) % columns * (first.width + kGap);
    };
    const auto top = [&](std::size_t i) {
        return kGap + static_cast<int>(i) / columns * (first.height + kGap);
    };
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        copy_into(sheet, frames_[i].image, left(i), top(i));
    }
    const Fonts fonts;
    const Canvas canvas(sheet, fonts);
    const TextStyle style = {kTextSize, true, {1, 1, 1, 1}, 0.0, 1};
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const std::string text = fixed(frames_[i].time, 2) + " s";
        const Eigen::Vector2d size = canvas.text_size(text, style);
        canvas.label(left(i) + 6 + 0.5 * size.x(), top(i) + first.height - 4 - 0.5 * size.y(), text, style);
    }
    return canvas.image();
}

}  // namespace campuswalk::engine::render
