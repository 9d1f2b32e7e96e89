#include "config/loader/read_status.h"

#include <array>

#include "config/loader/checked_map.h"
#include "config/loader/names.h"

namespace campuswalk::config {

using engine::WalkStatus;

namespace {

using Kind = WalkStatus::Kind;
constexpr std::array kKinds = {Choice<Kind>{"run", Kind::run}, Choice<Kind>{"skip", Kind::skip},
                               Choice<Kind>{"only", Kind::only}, Choice<Kind>{"xfail", Kind::xfail}};

std::vector<std::string> read_codes(const CheckedNode& node) {
    const std::vector<std::string> known = engine::failure_codes();
    std::vector<std::string> codes;
    const std::vector<CheckedNode> items = node.items_or_one("a failure");
    for (const CheckedNode& item : items) {
        if (const auto index = item.one_of(known)) {
            codes.push_back(known[*index]);
        }
    }
    if (items.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", "'failures' needs at least one; leave it out if any will do");
    }
    return codes;
}

}  // namespace

WalkStatus read_status(const CheckedNode& node) {
    WalkStatus status;
    status.mark = node.mark();
    if (!node.is_map()) {
        status.kind = node.choice(kKinds).value_or(Kind::run);
        return status;
    }
    CheckedMap map(node, "'status'");
    map.require("is");
    map.choice("is", kKinds, status.kind);
    if (const auto because = map.find("because")) {
        status.reason = because->line().value_or("");
    }
    if (const auto failures = map.find("failures")) {
        status.codes = read_codes(*failures);
        if (status.kind != Kind::xfail) {
            map.diagnose_at("failures", "bad-value", "'failures' are for walks that are xfail");
        }
    }
    map.refuse_other_keys();
    return status;
}

std::vector<std::string> read_tags(const CheckedNode& node) {
    std::vector<std::string> tags;
    UniqueNames names("tag");
    for (const CheckedNode& item : node.items_or_one("a tag")) {
        if (const auto tag = kebab_name(item)) {
            tags.push_back(*tag);
            names.add(*tag, item);
        }
    }
    return tags;
}

}  // namespace campuswalk::config
