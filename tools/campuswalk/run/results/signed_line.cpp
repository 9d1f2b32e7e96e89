#include "tools/campuswalk/run/results/signed_line.h"

#include <cstddef>
#include <span>
#include <stdexcept>

#include "scene/cache/content_hash.h"

namespace campuswalk::tools {

namespace {

constexpr std::string_view kCodeBegin = "{\"code\":\"";
constexpr std::string_view kCodeEnd = "\",";
constexpr std::size_t kCodeSize = 2 * sizeof(scene::ContentHash);
constexpr std::size_t kSignatureSize = kCodeBegin.size() + kCodeSize + kCodeEnd.size();

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

}  // namespace

std::string signed_line(std::string_view object, std::string_view context, std::string_view key) {
    std::string text(context);
    text += '\n';
    text += object;
    std::string line(kCodeBegin);
    line += to_string(scene::keyed_hash_of(bytes_of(text), bytes_of(key)));
    line += kCodeEnd;
    line += object.substr(1);
    return line;
}

bool has_signature(std::string_view line) {
    return line.size() > kSignatureSize && line.starts_with(kCodeBegin) &&
           line.substr(kCodeBegin.size() + kCodeSize, kCodeEnd.size()) == kCodeEnd;
}

std::string unsigned_line(std::string_view line) {
    if (!has_signature(line)) {
        throw std::runtime_error("not a line that a run has signed");
    }
    return "{" + std::string(line.substr(kSignatureSize));
}

bool is_authentic(std::string_view line, std::string_view context, std::string_view key) {
    return !key.empty() && has_signature(line) && signed_line(unsigned_line(line), context, key) == line;
}

}  // namespace campuswalk::tools
