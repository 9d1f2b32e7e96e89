#include "scene/import/helper/image_process.h"

#include <exception>

#include "scene/base/binary_archive.h"
#include "scene/import/helper/helper_streams.h"
#include "scene/import/source/decode_image.h"

namespace campuswalk::scene {
namespace {

constexpr FileKind kImageRequest = {{'c', 'w', ' ', 'p', 'i', 'c', 'r', 'q'}, 1};
constexpr FileKind kImageResponse = {{'c', 'w', ' ', 'p', 'i', 'c', 'r', 's'}, 1};
constexpr std::uint64_t kBytesPerPixel = 4;

/// A picture of 64 million pixels takes a gigabyte while it is decoded, and less than two seconds.
constexpr ImportLimits kLimits = {.memory = std::uint64_t{4} << 30U, .cpu = 60};

std::uint32_t big_endian_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < sizeof number; ++i) {
        number = (number << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return number;
}

std::vector<std::byte> write_request(std::span<const std::string_view> files, SandboxMode sandbox) {
    ArchiveWriter out(kImageRequest);
    out.put(static_cast<std::uint32_t>(sandbox));
    out.put(static_cast<std::uint64_t>(files.size()));
    for (const std::string_view file : files) {
        out.put_text(file);
    }
    return concatenated(out.finish());
}

DecodedImage decoded(const std::string& file, std::string& fault) {
    if (!png_size(file)) {
        fault = "isn't a PNG file";
        return {};
    }
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
    return decode_image(bytes, fault).value_or(DecodedImage());
}

std::vector<ForeignImage> read_response(const HelperResponse& response,
                                        std::span<const std::string_view> files) {
    ArchiveReader in(response.bytes, kImageResponse, response.owner);
    std::vector<ForeignImage> images(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        ForeignImage& image = images[i];
        image.fault = in.take_text();
        if (image.fault.empty()) {
            image.size = png_size(files[i]).value_or(ImageSize());
            image.rgba =
                in.take_aligned<std::uint8_t>(static_cast<std::size_t>(kBytesPerPixel * image.size.pixels()));
        }
    }
    in.finish();
    return images;
}

std::vector<ForeignImage> all_with(const std::string& fault, std::size_t count) {
    return std::vector<ForeignImage>(count, ForeignImage{{}, {}, fault});
}

}  // namespace

std::optional<ImageSize> png_size(std::string_view file) {
    constexpr std::string_view kBeginning("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    constexpr std::size_t kEnough = 24;
    if (file.size() < kEnough || !file.starts_with(kBeginning)) {
        return std::nullopt;
    }
    return ImageSize{big_endian_at(file, 16), big_endian_at(file, 20)};
}

std::vector<ForeignImage> decode_in_process(const HelperProgram& helper,
                                            std::span<const std::string_view> files, SandboxMode sandbox) {
    const HelperResponse response =
        ask_helper(helper, write_request(files, sandbox), kLimits, {"make it smaller", "make it again"});
    if (!response.failure.empty()) {
        return all_with("can't be decoded: " + response.failure, files.size());
    }
    try {
        return read_response(response, files);
    } catch (const DamagedFile& damage) {
        return all_with(std::string("was decoded to invalid data (") + damage.what() + "); do not trust it",
                        files.size());
    }
}

int serve_images() {
    const std::vector<std::byte> bytes = read_helper_request();
    if (bytes.empty()) {
        return 2;
    }
    try {
        ArchiveReader in(bytes, kImageRequest);
        const auto sandbox = static_cast<SandboxMode>(in.take_below(3, "sandbox"));
        limit_process(kLimits);
        enter_sandbox({}, sandbox);
        ArchiveWriter out(kImageResponse);
        std::vector<DecodedImage> images(in.take_count(1));  // the writer refers to their pixels
        for (DecodedImage& image : images) {
            std::string fault;
            image = decoded(in.take_text(), fault);
            out.put_text(fault);
            out.put_aligned(std::span<const std::uint8_t>(image.rgba));
        }
        in.finish();
        end_helper(out);
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace campuswalk::scene
