#pragma once

#include <array>
#include <string_view>

// The codes of failures that aren't the names of expectations. tools/docs_site/diagnostics.toml says what
// each means.

namespace campuswalk::engine {

// Why a walk ends early. A status can expect these.
inline constexpr std::string_view kBlockedCode = "blocked";
inline constexpr std::string_view kEnclosedCode = "enclosed";
inline constexpr std::string_view kTimeoutCode = "timeout";
inline constexpr std::string_view kUnreachableCode = "unreachable";
inline constexpr std::array kStopCodes = {kBlockedCode, kEnclosedCode, kTimeoutCode, kUnreachableCode};

// These say nothing about a walk: something that its verdict needs is lacking. No status can expect them.
inline constexpr std::string_view kGoldenMissing = "golden-missing";        ///< a golden log or image
inline constexpr std::string_view kGoldenUnreadable = "golden-unreadable";  ///< a golden image
inline constexpr std::string_view kSnapshotMissing = "snapshot-missing";    ///< no step took it
inline constexpr std::string_view kNotEvaluated =
    "not-evaluated";  ///< nothing draws images, or the walk ended before
inline constexpr std::string_view kRouteUnknown = "route-unknown";  ///< a search for one was cut
inline constexpr std::array kLackCodes = {kGoldenMissing, kGoldenUnreadable, kSnapshotMissing, kNotEvaluated,
                                          kRouteUnknown};

inline constexpr std::string_view kXfailCode = "xfail";             ///< a walk should have failed but didn't
inline constexpr std::string_view kNotIdentical = "not-identical";  ///< its repetitions differ

}  // namespace campuswalk::engine
