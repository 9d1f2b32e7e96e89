#pragma once

namespace campuswalk::tools {

/// What draws pictures, as the command line has it.
enum class Backend { automatic, osmesa, egl, none };

/// Whether pictures are to be drawn. Throws scene::InputError for a backend that this build hasn't got.
bool wants_pictures(Backend backend);

/// For a command that is there to draw. Throws scene::InputError for `none`, std::runtime_error in a build
/// without rendering.
void require_pictures(Backend backend);

}  // namespace campuswalk::tools
