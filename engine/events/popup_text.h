#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/campus/campus_description.h"

namespace campuswalk::engine {

/// A stretch of a pop-up's title or text.
struct TextPart {
    bool is_variable = false;
    std::string text;    ///< as it is, or the variable's name
    std::size_t at = 0;  ///< of a variable: the byte of the text where its brace is
};

/// `{name}` is a variable, `{{` and `}}` are braces, and so is a `}` by itself. None when a `{` is never
/// closed.
std::optional<std::vector<TextPart>> text_parts(const std::string& text);

/// Which variables a building's text may hold; those of its title are the same but for `title`.
std::vector<std::string> popup_variables(const scene::Building& building);

/// What only the walk knows.
struct PopupFacts {
    int visits = 0;     ///< how often the window has opened, this time included
    double time = 0.0;  ///< simulated seconds, shown as mm:ss
};

/// What the window shows. The building's texts are right: the loader has checked them.
std::string popup_title(const scene::Building& building, const PopupFacts& facts);
std::string popup_text(const scene::Building& building, const PopupFacts& facts);

}  // namespace campuswalk::engine
