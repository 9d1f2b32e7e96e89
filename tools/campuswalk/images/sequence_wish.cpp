#include "tools/campuswalk/images/sequence_wish.h"

namespace campuswalk::tools {

const std::vector<AnimationKind>& animation_kinds() {
    static const std::vector<AnimationKind> kinds = {{"apng", "animation.png", "image/apng"},
                                                     {"gif", "animation.gif", "image/gif"}};
    return kinds;
}

}  // namespace campuswalk::tools
