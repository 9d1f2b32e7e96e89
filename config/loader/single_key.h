#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/checked_node.h"
#include "config/loader/complaint_limit.h"
#include "config/loader/wording.h"

namespace campuswalk::config {

/// A list's entry that says by its only key what it is, as in `- wait: 2`: the key's meaning and its value.
template <typename Meaning>
struct SingleKey {
    std::string_view key;  ///< as in the choices
    Meaning meaning{};
    CheckedNode value;
};

/// Complains when the entry is no map, has more than one key, or its key is none of the choices.
/// `what` names such an entry, as in "a step".
template <typename Meaning, std::size_t count>
std::optional<SingleKey<Meaning>> single_key(const CheckedNode& node, const std::string& what,
                                             const std::array<Choice<Meaning>, count>& choices) {
    if (!node.is_map()) {
        node.diagnose("wrong-type", what + " must be a key with a value, as in '" +
                                        std::string(choices.front().name) + ": …'");
        return std::nullopt;
    }
    const std::vector<CheckedNode::Entry> entries = node.entries();
    if (entries.size() != 1) {
        node.diagnose("bad-value", entries.empty()
                                       ? what + " is empty"
                                       : what + " has one key; start " + in_quotes(entries[1].key) +
                                             " on a line of its own with '- '");
        return std::nullopt;
    }
    std::vector<std::string> known;
    for (const Choice<Meaning>& choice : choices) {
        if (choice.name == entries.front().key) {
            return SingleKey<Meaning>{choice.name, choice.value, entries.front().value};
        }
        known.emplace_back(choice.name);
    }
    add_diagnostic(node.diagnostics(), entries.front().key_mark, "unknown-key",
                   "unknown key " + in_quotes(entries.front().key) + " for " + what +
                       suggestion_or_list(entries.front().key, known));
    return std::nullopt;
}

}  // namespace campuswalk::config
