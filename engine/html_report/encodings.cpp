#include "engine/html_report/encodings.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <new>

#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

std::uint32_t byte(char value) {
    return static_cast<unsigned char>(value);
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    char* digit = text.data();
    for (; bytes.size() >= 3; bytes.remove_prefix(3)) {  // megabytes of geometry: each branch would cost
        const std::uint32_t bits = byte(bytes[0]) << 16U | byte(bytes[1]) << 8U | byte(bytes[2]);
        *digit++ = kDigits[bits >> 18U];
        *digit++ = kDigits[bits >> 12U & 63U];
        *digit++ = kDigits[bits >> 6U & 63U];
        *digit++ = kDigits[bits & 63U];
    }
    if (!bytes.empty()) {
        const std::uint32_t bits = byte(bytes[0]) << 16U | (bytes.size() > 1 ? byte(bytes[1]) << 8U : 0U);
        *digit++ = kDigits[bits >> 18U];
        *digit++ = kDigits[bits >> 12U & 63U];
        if (bytes.size() > 1) {
            *digit++ = kDigits[bits >> 6U & 63U];
        }
    }
    return text;
}

Gzip::Gzip(int effort) : compressor_(libdeflate_alloc_compressor(effort)) {
    if (compressor_ == nullptr) {
        throw std::bad_alloc();
    }
}

std::string_view Gzip::pack(std::string_view bytes) {
    const std::size_t bound = libdeflate_gzip_compress_bound(compressor_.get(), bytes.size());
    packed_.resize(std::max(packed_.size(), bound));
    const std::size_t size = libdeflate_gzip_compress(compressor_.get(), bytes.data(), bytes.size(),
                                                      packed_.data(), packed_.size());
    return {packed_.data(), size};
}

void Gzip::Free::operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
}

std::string html_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : scene::printable(text)) {
        escaped += c == '&'   ? std::string_view("&amp;")
                   : c == '<' ? std::string_view("&lt;")
                   : c == '>' ? std::string_view("&gt;")
                   : c == '"' ? std::string_view("&quot;")
                              : std::string_view(&c, 1);
    }
    return escaped;
}

}  // namespace campuswalk::engine
