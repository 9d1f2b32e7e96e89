#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

// Judges of which information windows open; see event_evaluators.h.

class PopupJudge {
public:
    explicit PopupJudge(const ExpectPopup& expected) : expected_(&expected) {}
    void see(const FrameRecord& record, const Moment& now);
    Finding finding(bool ended) const;

private:
    const ExpectPopup* expected_;
    int times_ = 0;
    std::string other_;  ///< the last of the building that said something else, as it would be told
    std::optional<Moment> when_;
};

class VisitsJudge {
public:
    VisitsJudge(const ExpectVisits& expected, const scene::Campus& campus);
    void see(const FrameRecord& record, const Moment& now);
    Finding finding(bool ended) const;

private:
    const ExpectVisits* expected_;
    std::vector<std::string> wanted_;  ///< in the campus' order
    std::set<std::string> visited_;    ///< of those
};

}  // namespace campuswalk::engine
