#include "engine/html_report/html_page.h"

#include <span>
#include <stdexcept>
#include <utility>

#include "scene/cache/content_hash.h"

namespace campuswalk::engine {

namespace {

constexpr int kEffort = 3;  // of gzip: 6 takes twice the time for a tenth less
/// Bytes that are encoded at a time, a multiple of three: megabytes of geometry needn't be in memory again.
constexpr std::size_t kPiece = 48UL * 1024;

/// A source expression of Content Security Policy level 3.
std::string hash_source(std::string_view text) {
    const scene::ContentHash hash = scene::hash_of(std::as_bytes(std::span(text)));
    const std::string_view bytes(reinterpret_cast<const char*>(hash.bytes.data()), hash.bytes.size());
    return "'sha256-" + base64(bytes) + "'";
}

std::string policy(const ViewerBundle& bundle) {
    return "default-src 'none'; script-src " + hash_source(bundle.script) +
           " 'wasm-unsafe-eval'; style-src " + hash_source(bundle.style) +
           "; img-src blob: data:; connect-src blob: data:; worker-src blob:; base-uri 'none'; "
           "form-action 'none'";
}

}  // namespace

HtmlPage::HtmlPage(TextSink sink, const ViewerBundle& bundle)
    : sink_(std::move(sink)), bundle_(bundle), gzip_(kEffort) {
    for (const std::string_view breaking : {"</script", "<!--"}) {
        if (bundle.script.find(breaking) != std::string_view::npos) {
            throw std::invalid_argument("the viewer's script would end the script element");
        }
    }
    if (bundle.style.find("</style") != std::string_view::npos) {
        throw std::invalid_argument("the viewer's style would end the style element");
    }
}

void HtmlPage::begin(std::string_view title) {
    sink_(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
        policy(bundle_) +
        "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        html_escaped(title) + "</title>\n<style>");
    sink_(bundle_.style);
    sink_(
        "</style></head>\n<body><noscript>This report is shown by a script that is part of it: allow scripts "
        "for "
        "this file. Nothing is loaded from anywhere.</noscript><div id=\"app\"></div>\n");
}

std::size_t HtmlPage::add_data(std::string_view bytes) {
    return add_packed(gzip_.pack(bytes));
}

std::size_t HtmlPage::add_packed(std::string_view gzip) {
    add_chunk(std::to_string(chunks_), "", gzip);
    return chunks_++;
}

std::size_t HtmlPage::add_image(std::string_view bytes, std::string_view media_type) {
    add_chunk(std::to_string(chunks_), " data-type=\"" + html_escaped(media_type) + "\"", bytes);
    return chunks_++;
}

void HtmlPage::finish(std::string_view index) {
    add_chunk("index", "", gzip_.pack(index));
    sink_("<script>");
    sink_(bundle_.script);
    sink_("</script></body></html>\n");
}

void HtmlPage::add_chunk(const std::string& number, std::string_view attributes, std::string_view bytes) {
    sink_("<script type=\"application/x-campuswalk\" data-chunk=\"" + number + "\"" +
          std::string(attributes) + ">");
    for (; bytes.size() > kPiece; bytes.remove_prefix(kPiece)) {
        sink_(base64(bytes.substr(0, kPiece)));
    }
    sink_(base64(bytes) + "</script>\n");
}

}  // namespace campuswalk::engine
