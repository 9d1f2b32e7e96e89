#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "config/loader/walk/campus_names.h"
#include "engine/script/avatar.h"

namespace campuswalk::config {

/// Reads avatars as walks write them: a profile's name, or a map that overrides keys of a profile.
class AvatarReader {
public:
    /// Profiles are looked for near `folder`, then in the folders `more`; the files of those that are read
    /// are added to `profiles`. The last three must outlive the reader.
    AvatarReader(std::filesystem::path folder, std::vector<std::filesystem::path> more,
                 const ReadRoots& roots, const CampusNames& names,
                 std::vector<std::filesystem::path>& profiles)
        : folder_(std::move(folder)),
          more_(std::move(more)),
          roots_(roots),
          names_(names),
          profiles_(profiles) {}

    engine::AvatarProfile read(const CheckedNode& node) const;

private:
    engine::AvatarProfile named(const CheckedNode& node) const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> more_;
    const ReadRoots& roots_;
    const CampusNames& names_;
    std::vector<std::filesystem::path>& profiles_;
};

/// Reads a NAME.avatar.yaml. `named_at` is where the file is named: in another file, or the file itself.
engine::AvatarProfile open_avatar(const std::filesystem::path& path, const ReadRoots& roots,
                                  const scene::SourceMark& named_at, scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
