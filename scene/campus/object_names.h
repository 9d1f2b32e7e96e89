#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::scene {

/// A node's name as a word of an object id: ASCII letters in lower case, every run of other ASCII characters
/// than letters and digits one `-`, none at the ends; characters beyond ASCII stay. `Tree_01.Leaf` becomes
/// `tree-01-leaf`; a name of which nothing is left becomes `node`.
std::string object_word(std::string_view node_name);

/// object_word of each name, made distinct: of equal words the second gets `-2`, the third `-3`, …, in the
/// given order, passing over numbers that another node's name takes.
std::vector<std::string> distinct_words(const std::vector<std::string>& node_names);

}  // namespace campuswalk::scene
