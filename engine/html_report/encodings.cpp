#include "engine/html_report/encodings.h"

#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <new>

#include "engine/report/plain_text.h"

namespace campuswalk::engine {

namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            bits = (bits << 8U) | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        }
        for (unsigned i = 0; i < 4; ++i) {
            text += at + i > bytes.size() ? '=' : kDigits[(bits >> (18U - 6U * i)) & 63U];
        }
    }
    return text;
}

std::string gzip(std::string_view bytes, int effort) {
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(effort));
    if (compressor == nullptr) {
        throw std::bad_alloc();
    }
    std::string packed(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
    packed.resize(
        libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return packed;
}

std::string html_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : valid_utf8(text)) {
        escaped += c == '&'   ? std::string_view("&amp;")
                   : c == '<' ? std::string_view("&lt;")
                   : c == '>' ? std::string_view("&gt;")
                   : c == '"' ? std::string_view("&quot;")
                              : std::string_view(&c, 1);
    }
    return escaped;
}

}  // namespace campuswalk::engine
