#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace campuswalk::scene {

/// The codes of all errors and warnings, sorted. tools/docs_site/diagnostics.toml says what each means.
inline constexpr auto kDiagnosticCodes = std::to_array<std::string_view>({
    "ambiguous-element",
    "bad-crs",
    "bad-encoding",
    "bad-geography",
    "bad-heights",
    "bad-last-run",
    "bad-location",
    "bad-map",
    "bad-model",
    "bad-picture",
    "bad-pose",
    "bad-regex",
    "bad-report",
    "bad-shape",
    "bad-shard",
    "bad-size",
    "bad-texture",
    "bad-times",
    "bad-value",
    "bad-vertex",
    "blocked-door",
    "bridge-at-ground",
    "cache-unwritable",
    "closed-openings",
    "coarse-position",
    "door-size",
    "duplicate-faces",
    "duplicate-id",
    "duplicate-key",
    "duplicate-name",
    "duplicate-shard",
    "empty-file",
    "empty-mesh",
    "empty-ring",
    "entrance-on-floor",
    "entrance-without-wall",
    "expects-nothing",
    "far-from-origin",
    "far-place",
    "file-exists",
    "file-name",
    "folder-unreadable",
    "foreign-output",
    "foreign-results",
    "hidden-nodes",
    "huge-building",
    "include-cycle",
    "include-depth",
    "incomplete-relation",
    "incomplete-report",
    "incomplete-way",
    "indoor-ways",
    "job-unfinished",
    "json-syntax",
    "large-area",
    "log-unwritable",
    "long-line",
    "lost-geometry",
    "mirrored-node",
    "missing-data",
    "missing-file",
    "missing-key",
    "missing-materials",
    "missing-nodes",
    "missing-shard",
    "no-extent",
    "no-files",
    "no-ground",
    "no-ground-below",
    "no-inside",
    "no-log",
    "no-node",
    "no-origin",
    "no-places",
    "no-rendering",
    "no-result",
    "no-sandbox",
    "no-start",
    "no-triangles",
    "no-visits",
    "no-walks",
    "not-a-folder",
    "not-a-point",
    "not-built",
    "not-empty",
    "not-solid",
    "nothing-to-replay",
    "odd-levels",
    "odd-scale",
    "odd-steps",
    "only-forbidden",
    "open-parts",
    "open-ring",
    "other-plan",
    "other-run",
    "outlier",
    "output-unwritable",
    "outside-project",
    "oversized-element",
    "pier-without-bridge",
    "plan-too-large",
    "points-and-lines",
    "repaired-normals",
    "repaired-uvs",
    "repeated-name",
    "report-unwritable",
    "roof-shape",
    "solid-door",
    "spawn-blocked",
    "spawn-in-air",
    "stair-riser",
    "steep-bridge",
    "steep-ramp",
    "strict",
    "task-cancelled",
    "task-failed",
    "task-lost",
    "task-timed-out",
    "too-few-cases",
    "too-large",
    "too-large-models",
    "too-many",
    "too-many-layers",
    "too-many-scenes",
    "too-many-steps",
    "too-many-ticks",
    "too-many-triangles",
    "underground",
    "underground-building",
    "unevaluated-walks",
    "unknown-barrier",
    "unknown-key",
    "unknown-name",
    "unknown-shape",
    "unknown-walk",
    "unnamed-feature",
    "unnamed-node",
    "unplaced-mesh",
    "unreachable-place",
    "unreadable",
    "unreadable-file",
    "unreadable-length",
    "unsigned-reports",
    "unsupported-feature",
    "untagged-passage",
    "wrong-type",
    "yaml-syntax",
    "z-up",
    "zero-area",
});
static_assert(std::ranges::is_sorted(kDiagnosticCodes));

/// One of kDiagnosticCodes, or none. A literal that isn't among them doesn't compile.
class DiagnosticCode {
public:
    DiagnosticCode() = default;
    template <std::size_t Size>
    consteval DiagnosticCode(const char (&literal)[Size]) : text_(find(literal).value().text_) {}

    /// For codes that come from a file or another process; nothing if there is no such code.
    static constexpr std::optional<DiagnosticCode> find(std::string_view text) {
        const auto* known = std::ranges::lower_bound(kDiagnosticCodes, text);
        return known != kDiagnosticCodes.end() && *known == text ? std::optional(DiagnosticCode(known))
                                                                 : std::nullopt;
    }

    constexpr bool empty() const { return text_.empty(); }
    constexpr std::string_view text() const { return text_; }

    friend bool operator==(const DiagnosticCode&, const DiagnosticCode&) = default;

private:
    constexpr explicit DiagnosticCode(const std::string_view* known) : text_(*known) {}

    std::string_view text_;
};

}  // namespace campuswalk::scene
