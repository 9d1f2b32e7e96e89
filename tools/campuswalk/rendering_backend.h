#pragma once

namespace campuswalk::tools {

/// What draws images, as the command line has it.
enum class Backend { automatic, osmesa, egl, none };

/// Whether images are to be drawn. Throws scene::InputError for a backend that this build hasn't got.
bool wants_images(Backend backend);

/// For a command that is there to draw. Throws scene::InputError for `none`, std::runtime_error in a build
/// without rendering.
void require_images(Backend backend);

}  // namespace campuswalk::tools
