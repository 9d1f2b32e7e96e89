#include "config/loader/campus/read_popup.h"

#include <algorithm>

#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/wording.h"
#include "engine/events/popup_text.h"

namespace campuswalk::config {

namespace {

void check_variables(const CheckedNode& node, const std::string& text,
                     const std::vector<std::string>& known) {
    const auto parts = engine::text_parts(text);
    if (!parts) {
        node.diagnose("bad-value", node.what() + " has an unclosed '{'; write '{{' for a brace");
        return;
    }
    for (const engine::TextPart& part : *parts) {
        if (part.is_variable && std::ranges::find(known, part.text) == known.end()) {
            node.diagnose("unknown-name", node.what() + " has no variable " +
                                              in_quotes("{" + part.text + "}") +
                                              suggestion_or_list(part.text, known));
        }
    }
}

}  // namespace

void read_popup_rule(CheckedMap& map, bool& popup, scene::PopupRule& rule) {
    const auto node = map.find("popup");
    if (!node) {
        return;
    }
    if (!node->is_map()) {
        popup = node->as_bool().value_or(popup);
        return;
    }
    popup = true;
    rule = {};
    CheckedMap keys(*node, "'popup'");
    keys.as_bool("once", rule.once);
    keys.number("cooldown", kSeconds, rule.cooldown);
    keys.number("dwell", kSeconds, rule.dwell);
    keys.refuse_other_keys();
}

std::vector<scene::InfoField> read_info(const CheckedNode& node) {
    const std::vector<std::string> taken = engine::popup_variables({});
    std::vector<scene::InfoField> fields;
    for (const CheckedNode::Entry& entry : node.entries()) {
        check_kebab_key(entry);
        if (std::ranges::find(taken, entry.key) != taken.end()) {
            entry.value.diagnostics().error(
                entry.key_mark, "duplicate-name",
                "the variable " + in_quotes(entry.key) + " is predefined; give the field another name");
        }
        fields.push_back({entry.key, entry.value.text().value_or("")});
    }
    return fields;
}

void check_popup_title(const CheckedNode& node, const scene::Building& building) {
    std::vector<std::string> known = engine::popup_variables(building);
    std::erase(known, "title");
    check_variables(node, building.title, known);
}

void check_popup_text(const CheckedNode& node, const scene::Building& building) {
    check_variables(node, building.text, engine::popup_variables(building));
}

}  // namespace campuswalk::config
