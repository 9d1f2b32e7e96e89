#pragma once

#include <string>
#include <string_view>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// A frame as bytes, for another process on the same machine.
std::string serialize(const Frame& frame);

/// Throws std::runtime_error if the bytes are no valid frame.
Frame deserialize_frame(std::string_view bytes);

}  // namespace campuswalk::engine::render
