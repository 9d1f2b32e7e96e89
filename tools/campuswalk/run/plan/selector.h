#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace re2 {
class RE2;
}

namespace campuswalk::tools {

/// Which walks are wanted. Regular expressions are RE2's: linear time, whatever a user writes.
class Selector {
public:
    /// Only walks that the expression finds in `FILE NAME TAGS…`; each further one narrows. `mark` is where
    /// it was written. Throws scene::InputError (bad-regex).
    void require(const std::string& regex, const scene::SourceMark& mark);
    /// Only walks in which it finds nothing.
    void refuse(const std::string& regex, const scene::SourceMark& mark);
    /// Only walks with one of the tags; any walk if there are none.
    void require_tag(const std::vector<std::string>& tags);

    bool takes(const std::string& file, const std::string& name, const std::vector<std::string>& tags) const;
    /// The same of a walk whose tags aren't known: it may have any.
    bool may_take(const std::string& file, const std::string& name) const;

private:
    bool found_by_expressions(const std::string& text) const;

    std::vector<std::shared_ptr<const re2::RE2>> required_;
    std::vector<std::shared_ptr<const re2::RE2>> refused_;
    std::vector<std::vector<std::string>> tags_;
};

}  // namespace campuswalk::tools
