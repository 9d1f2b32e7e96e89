#include "config/loader/yaml/yaml_syntax.h"

#include <algorithm>
#include <array>

namespace campuswalk::config {

namespace {

struct Explanation {
    std::string_view parser_message;
    std::string_view message;
};

constexpr std::string_view kIndentation =
    "this line doesn't fit the lines above: check its indentation, '-' and ':'";
constexpr std::string_view kStrangeCharacter = "a value can't start with this character; put it in quotes";

constexpr std::array kExplanations = {
    Explanation{"end of map not found", kIndentation},
    Explanation{"end of sequence not found", kIndentation},
    Explanation{"end of map flow not found", "this '{' has no matching '}', or a ',' is missing after it"},
    Explanation{"end of sequence flow not found",
                "this '[' has no matching ']', or a ',' is missing after it"},
    Explanation{"illegal EOF in scalar", "an opening quote above is never closed"},
    Explanation{"illegal flow end", "this bracket has no opening bracket"},
    Explanation{"illegal map value", "a second ': ' on this line; put text that contains a colon in quotes"},
    Explanation{"illegal map key", kIndentation},
    Explanation{"illegal block entry", "a '- ' isn't allowed here; start it on a new line"},
    Explanation{"unknown token", kStrangeCharacter},
    Explanation{"alias not found after *", "'*' starts an alias; put the text in quotes"},
    Explanation{"anchor not found after &", "'&' starts an anchor; put the text in quotes"},
    Explanation{"the referenced anchor is not defined",
                "unknown anchor; put the text in quotes if you didn't mean an alias"}};

}  // namespace

std::string explained(const std::string& parser_message) {
    const auto found = std::ranges::find(kExplanations, parser_message, &Explanation::parser_message);
    return found == kExplanations.end() ? parser_message : std::string(found->message);
}

bool is_quote_unclosed(std::string_view text, std::size_t at) {
    while (at < text.size() && (text[at] == '&' || text[at] == '!')) {
        at = text.find_first_not_of(" \t\n", text.find_first_of(" \t\n", at));
    }
    if (at >= text.size() || (text[at] != '\'' && text[at] != '"')) {
        return false;
    }
    const char quote = text[at];
    for (++at; at < text.size(); ++at) {
        const bool doubled = quote == '\'' && text.substr(at, 2) == "''";
        if (doubled || (quote == '"' && text[at] == '\\')) {
            ++at;
        } else if (text[at] == quote) {
            return false;
        }
    }
    return true;
}

}  // namespace campuswalk::config
