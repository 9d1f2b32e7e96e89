#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::scene {

/// A node's name as a word of an object id: ASCII letters become lower case, each run of ASCII characters
/// other than letters and digits becomes one `-`, except at the ends; non-ASCII characters stay.
/// `Tree_01.Leaf` becomes `tree-01-leaf`; a name without any such character becomes `node`.
std::string object_word(std::string_view node_name);

/// The words made distinct: of equal ones the second gets `-2`, the third `-3`, …, in the given order,
/// skipping numbers that another word contains already.
std::vector<std::string> numbered(std::vector<std::string> words);

/// object_word of each name, made distinct.
std::vector<std::string> distinct_words(const std::vector<std::string>& node_names);

}  // namespace campuswalk::scene
