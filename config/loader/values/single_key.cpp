#include "config/loader/values/single_key.h"

#include <algorithm>

#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

std::optional<SingleKey> single_key(const CheckedNode& node, const std::string& what,
                                    std::string_view example, const std::vector<std::string>& known) {
    if (!node.is_map()) {
        node.diagnose("wrong-type",
                      what + " must be a map with a single key: write `" + std::string(example) + "`");
        return std::nullopt;
    }
    const std::vector<CheckedNode::Entry> entries = node.entries();
    if (entries.size() != 1) {
        node.diagnose("bad-value", entries.empty()
                                       ? what + " is empty"
                                       : what + " has a single key; put " + in_quotes(entries[1].key) +
                                             " into an entry of its own");
        return std::nullopt;
    }
    const CheckedNode::Entry& only = entries.front();
    if (std::ranges::find(known, only.key) == known.end()) {
        add_diagnostic(
            node.diagnostics(), only.key_mark, "unknown-key",
            "unknown key " + in_quotes(only.key) + " for " + what + suggestion_or_list(only.key, known));
        return std::nullopt;
    }
    return SingleKey{only.key, only.value};
}

}  // namespace campuswalk::config
