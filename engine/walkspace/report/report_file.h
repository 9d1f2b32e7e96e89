#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/base/binary_archive.h"

namespace campuswalk::engine {

/// Increment the version whenever a field is added, means something else or is found otherwise.
inline constexpr scene::FileKind kReportFile = {{'c', 'w', ' ', 'r', 'e', 'a', 'c', 'h'}, 13};

/// A report with its walk space, to be kept (see scene/base/binary_archive.h). `WalkTile::rim`, which only
/// the search for reasons needs, is left out.
std::vector<std::byte> archive_report(const WalkReport& report);

/// The inverse, for a campus of so many objects. The bytes are untrusted: throws scene::DamagedFile unless
/// everything in them that refers to something else can be followed.
WalkReport read_report_file(std::span<const std::byte> bytes, std::size_t objects);

}  // namespace campuswalk::engine
