#include "tools/campuswalk/run/plan/selector.h"

#include <re2/re2.h>

#include <algorithm>

namespace campuswalk::tools {

namespace {

std::shared_ptr<const re2::RE2> compiled(const std::string& regex, const scene::SourceMark& mark) {
    re2::RE2::Options options;
    options.set_log_errors(false);
    auto expression = std::make_shared<const re2::RE2>(regex, options);
    if (!expression->ok()) {
        throw scene::InputError(mark, "bad-regex",
                                "'" + regex + "' isn't a valid regular expression: " + expression->error());
    }
    return expression;
}

}  // namespace

void Selector::require(const std::string& regex, const scene::SourceMark& mark) {
    required_.push_back(compiled(regex, mark));
}

void Selector::refuse(const std::string& regex, const scene::SourceMark& mark) {
    refused_.push_back(compiled(regex, mark));
}

void Selector::require_tag(const std::vector<std::string>& tags) {
    if (!tags.empty()) {
        tags_.push_back(tags);
    }
}

bool Selector::matches_expressions(const std::string& text) const {
    const auto finds = [&](const auto& expression) { return re2::RE2::PartialMatch(text, *expression); };
    return std::ranges::all_of(required_, finds) && std::ranges::none_of(refused_, finds);
}

bool Selector::takes(const std::string& file, const std::string& name,
                     const std::vector<std::string>& tags) const {
    std::string text = file + " " + name;
    for (const std::string& tag : tags) {
        text += " " + tag;
    }
    const auto has = [&](const std::string& tag) { return std::ranges::find(tags, tag) != tags.end(); };
    return matches_expressions(text) &&
           std::ranges::all_of(tags_, [&](const auto& any) { return std::ranges::any_of(any, has); });
}

bool Selector::may_take(const std::string& file, const std::string& name) const {
    return matches_expressions(file + " " + name);
}

Selector selector_of(const config::ProjectConfig& project) {
    Selector selector;
    if (project.grep) {
        selector.require(project.grep->text, project.grep->mark);
    }
    if (project.grep_invert) {
        selector.refuse(project.grep_invert->text, project.grep_invert->mark);
    }
    selector.require_tag(project.tags);
    return selector;
}

}  // namespace campuswalk::tools
