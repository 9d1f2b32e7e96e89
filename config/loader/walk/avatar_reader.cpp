#include "config/loader/walk/avatar_reader.h"

#include "config/loader/profile/read_avatar.h"
#include "config/loader/profile/read_profile.h"
#include "config/loader/values/names.h"

namespace campuswalk::config {

using engine::AvatarProfile;

AvatarProfile AvatarReader::read(const CheckedNode& node) const {
    return read_profile<AvatarProfile>(kAvatars, node, files_, [&](CheckedMap& map, AvatarProfile& profile) {
        for (const CheckedNode& layer : read_profile_fields(map, profile)) {
            names_.check_layer(layer, name_in(layer).value_or(""));
        }
    });
}

}  // namespace campuswalk::config
