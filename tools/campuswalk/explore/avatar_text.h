#pragma once

#include <string>

#include "engine/script/avatar.h"

namespace campuswalk::tools::explore {

/// What a walk has to say after `avatar:` for this avatar, by what differs from the profile `name`: "adult",
/// or "{profile: adult, radius: 0.65}".
std::string avatar_text(const engine::AvatarProfile& avatar, const std::string& name,
                        const engine::AvatarProfile& profile);

/// The avatar as tall as it is while it crouches.
engine::AvatarProfile crouched(engine::AvatarProfile avatar);
/// The avatar with this width, metres.
engine::AvatarProfile widened(engine::AvatarProfile avatar, double width);

}  // namespace campuswalk::tools::explore
