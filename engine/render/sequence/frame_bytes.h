#pragma once

#include <string>
#include <string_view>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// A frame on its way between two processes of one machine.
std::string serialize(const Frame& frame);

/// Throws std::runtime_error for what isn't a frame.
Frame deserialize_frame(std::string_view bytes);

}  // namespace campuswalk::engine::render
