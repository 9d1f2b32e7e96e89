#pragma once

#include <utility>

#include "config/loader/profile/profile_search.h"
#include "config/loader/values/checked_node.h"
#include "config/loader/walk/campus_names.h"
#include "engine/script/avatar.h"

namespace campuswalk::config {

/// Reads avatars as walks write them: a profile's name, or a map that overrides keys of a profile.
class AvatarReader {
public:
    /// What `files` refers to, and the names, must outlive the reader.
    AvatarReader(ProfileFiles files, const CampusNames& names) : files_(std::move(files)), names_(names) {}

    engine::AvatarProfile read(const CheckedNode& node) const;

private:
    ProfileFiles files_;
    const CampusNames& names_;
};

}  // namespace campuswalk::config
