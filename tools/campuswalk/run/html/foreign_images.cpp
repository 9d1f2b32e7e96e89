#include "tools/campuswalk/run/html/foreign_images.h"

#include <memory>
#include <optional>
#include <utility>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace {

class ImageReading {
public:
    ImageReading(ImageDecoder decode, const ImageBudget& budget)
        : decode_(std::move(decode)), budget_(budget) {}

    void read(const engine::FileReader& read, const std::vector<std::string>& paths,
              const std::function<void(std::size_t, const scene::PixelView&)>& visit) {
        std::vector<Waiting> waiting;
        std::uint64_t pixels = 0;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            std::optional<std::string> bytes = read(paths[i]);
            const std::uint64_t size = bytes ? admitted_pixels(paths[i], *bytes) : 0;
            if (size == 0) {
                continue;
            }
            if (pixels + size > budget_.pixels_at_once) {
                decode(std::exchange(waiting, {}), paths, visit);
                pixels = 0;
            }
            pixels += size;
            waiting.push_back({i, std::move(*bytes)});
        }
        decode(waiting, paths, visit);
    }

private:
    struct Waiting {
        std::size_t index = 0;
        std::string bytes;
    };

    static void leave_out(const std::string& path, const std::string& why) {
        diagnose(
            {{scene::Severity::warning, {path, 0, 0}, "bad-picture", why + "; the report is without it"}});
    }

    /// 0 for a picture that is left out, with a warning.
    std::uint64_t admitted_pixels(const std::string& path, const std::string& bytes) {
        const std::optional<scene::ImageSize> size = scene::png_size(bytes);
        const std::uint64_t pixels = size ? size->pixels() : 0;
        if (pixels == 0) {
            leave_out(path, "this is not a PNG file");
            return 0;
        }
        if (pixels > budget_.pixels_of_one) {
            leave_out(path, "the picture has " + std::to_string(size->width) + "x" +
                                std::to_string(size->height) + " pixels, and reports take at most " +
                                std::to_string(budget_.pixels_of_one));
            return 0;
        }
        if (taken_ + pixels > budget_.pixels_of_all) {
            leave_out(path, "with this picture, the report's would have " + std::to_string(taken_ + pixels) +
                                " pixels, and it takes at most " + std::to_string(budget_.pixels_of_all) +
                                "; make reports of fewer walks");
            return 0;
        }
        taken_ += pixels;
        return pixels;
    }

    void decode(const std::vector<Waiting>& waiting, const std::vector<std::string>& paths,
                const std::function<void(std::size_t, const scene::PixelView&)>& visit) const {
        if (waiting.empty()) {
            return;
        }
        std::vector<std::string_view> files;
        for (const Waiting& each : waiting) {
            files.emplace_back(each.bytes);
        }
        const std::vector<scene::ForeignImage> images = decode_(files);
        for (std::size_t i = 0; i < waiting.size(); ++i) {
            const scene::ForeignImage& image = images[i];
            if (image.fault.empty()) {
                visit(waiting[i].index,
                      {static_cast<int>(image.size.width), static_cast<int>(image.size.height),
                       std::span(image.rgba.data(), image.rgba.size())});
            } else {
                leave_out(paths[waiting[i].index], "the picture " + image.fault);
            }
        }
    }

    ImageDecoder decode_;
    ImageBudget budget_;
    std::uint64_t taken_ = 0;
};

}  // namespace

engine::ImageReader image_reader(ImageDecoder decode, const ImageBudget& budget) {
    return [reading = std::make_shared<ImageReading>(std::move(decode), budget)](
               const engine::FileReader& read, const std::vector<std::string>& paths,
               const std::function<void(std::size_t, const scene::PixelView&)>& visit) {
        reading->read(read, paths, visit);
    };
}

}  // namespace campuswalk::tools
