#pragma once

namespace campuswalk::support {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

/// How often a random test repeats: sanitizers make each repetition about ten times slower.
constexpr int repeats(int plain) {
    return kSanitized ? plain / 8 + 1 : plain;
}

}  // namespace campuswalk::support
