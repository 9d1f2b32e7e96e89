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

/// Whether a character isn't seen as itself in a line: it changes how those around it are shown
/// (controls_display() of utf8.h), or it looks like nothing or like a space. These are the spaces but U+0020
/// (also the no-break and the ideographic one), the code points that Unicode lets a font ignore (joiners,
/// variation selectors, blank Hangul letters, tags), the blank Braille pattern, and what is no character.
/// Marks that combine with the letter before them are seen.
bool is_unseen(char32_t code);

/// The text as an id: its letters and digits in lower case, normalized; each run of anything else between
/// them becomes one `-`. Empty without letters and digits.
std::string to_id_word(std::string_view text);

}  // namespace campuswalk::scene
