#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/campus/campus_description.h"

namespace campuswalk::engine {

/// A part of a pop-up's title or text.
struct TextPart {
    bool is_variable = false;
    std::string text;    ///< literal, or the variable's name
    std::size_t at = 0;  ///< of a variable: offset of its brace, bytes
};

/// `{name}` is a variable; `{{`, `}}` and a single `}` are braces. None if a `{` is never closed.
std::optional<std::vector<TextPart>> text_parts(const std::string& text);

/// The variables that a building's text may contain; its title may contain all of them but `title`.
std::vector<std::string> popup_variables(const scene::Building& building);

/// The values that depend on the walk.
struct PopupFacts {
    int visits = 0;     ///< how often the window has opened, this time included
    double time = 0.0;  ///< simulated seconds, shown as mm:ss
};

/// What the window shows. The loader has checked the building's texts.
std::string popup_title(const scene::Building& building, const PopupFacts& facts);
std::string popup_text(const scene::Building& building, const PopupFacts& facts);

}  // namespace campuswalk::engine
