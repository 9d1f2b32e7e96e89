#pragma once

#include <string>
#include <string_view>

namespace campuswalk::scene {

// Words of any script, by utf8proc (Unicode 15).

/// The text in normalization form C (Unicode Standard Annex #15), so that names which look alike are equal: a
/// file may spell é with one code point or with two. Text that isn't UTF-8 stays as it is.
std::string normalized(std::string_view text);

/// Whether the text is a word that may be an id: letters with their marks and decimal digits of any script,
/// `-`, `_` and `.`, of which none comes first or last.
bool is_id_word(std::string_view text);

/// The text as an id: its letters and digits in lower case, normalized; each run of anything else between
/// them becomes one `-`. Empty without letters and digits.
std::string to_id_word(std::string_view text);

}  // namespace campuswalk::scene
