#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {

/// Writes `folder`/views.json: the size, the field of view, the views and the number of rounds that peers
/// draw.
void write_views(const std::vector<DrawnView>& views, int rounds, const std::filesystem::path& folder);

/// Runs another program that draws: a shell command, with the folder, which holds campus.glb and views.json,
/// as its argument. It prints one line per image, `frame LOOK VIEW MS`, and may print other lines. Throws
/// std::runtime_error when it fails or prints no such line.
std::vector<DrawTimes> draw_peer(const std::string& name, const std::string& command,
                                 const std::filesystem::path& folder);

/// The times in the output of a peer. Throws std::runtime_error when there are none.
std::vector<DrawTimes> parse_times(const std::string& peer, const std::string& printed);

}  // namespace campuswalk::tools::bench
