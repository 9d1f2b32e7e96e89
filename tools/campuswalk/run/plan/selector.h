#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/loader/walks_config.h"
#include "scene/base/diagnostic.h"

namespace re2 {
class RE2;
}

namespace campuswalk::tools {

/// Selects walks. Regular expressions are RE2's: linear time, whatever a user writes.
class Selector {
public:
    /// Only takes walks in whose `FILE NAME TAGS…` the expression matches; further ones narrow the selection.
    /// `mark` is where it is written. Throws scene::InputError (bad-regex).
    void require(const std::string& regex, const scene::SourceMark& mark);
    /// Only takes walks where it doesn't match.
    void refuse(const std::string& regex, const scene::SourceMark& mark);
    /// Only takes walks with at least one of the tags; any walk if there are none.
    void require_tag(const std::vector<std::string>& tags);

    bool takes(const std::string& file, const std::string& name, const std::vector<std::string>& tags) const;
    /// Whether it takes a walk whose tags are unknown: it may have any.
    bool may_take(const std::string& file, const std::string& name) const;

private:
    bool matches_expressions(const std::string& text) const;

    std::vector<std::shared_ptr<const re2::RE2>> required_;
    std::vector<std::shared_ptr<const re2::RE2>> refused_;
    std::vector<std::vector<std::string>> tags_;
};

/// Which walks a project plays. Throws scene::InputError (bad-regex).
Selector selector_of(const config::ProjectConfig& project);

}  // namespace campuswalk::tools
