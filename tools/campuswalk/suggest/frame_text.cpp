#include "tools/campuswalk/suggest/frame_text.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "scene/lint/wording.h"

namespace campuswalk::tools {

using scene::Confidence;
using scene::FrameGuess;
using scene::Measure;
using scene::UpVote;

namespace {

std::string counted(std::size_t count, const char* things) {
    return std::to_string(count) + " " + things;
}

/// "62 % of its faces, by area, face Z", "54 risers of stairs climb along Z", "1 door is longest along Z"
std::string text_of(const UpVote& vote, scene::UpAxis up) {
    const double own = up == scene::UpAxis::z ? vote.z : vote.y;
    const std::string axis = up == scene::UpAxis::z ? "Z" : "Y";
    switch (vote.kind) {
        case UpVote::Kind::facing:
            return engine::fixed(100.0 * own, 0) + " % of its faces, by area, face " + axis;
        case UpVote::Kind::risers:
            return counted(static_cast<std::size_t>(own), "risers of stairs climb along ") + axis;
        case UpVote::Kind::doors:
            return counted(static_cast<std::size_t>(own),
                           own == 1.0 ? "door is longest along " : "doors are longest along ") +
                   axis;
    }
    return "";
}

std::string name_of(scene::UpAxis up) {
    return up == scene::UpAxis::z ? "z" : "y";
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

std::string votes_for(const FrameGuess& frame, scene::UpAxis up) {
    std::vector<std::string> parts;
    for (const UpVote& vote : frame.votes) {
        if ((vote.z > vote.y) == (up == scene::UpAxis::z)) {
            parts.push_back(text_of(vote, up));
        }
    }
    return joined(parts);
}

/// "5 houses are 0.9 m high"
std::string text_of(const Measure& measure, double scale) {
    const scene::UsualSize& usual = scene::usual_size(measure.kind);
    return counted(measure.count, measure.count == 1 ? usual.one : usual.name) +
           (measure.count == 1 ? " is " : " are ") + scene::in_metres(scale * measure.median) + " " +
           usual.does;
}

/// The measures that are usual at this scale, or the others.
std::vector<const Measure*> measures_that(const FrameGuess& frame, bool are_usual, double scale) {
    std::vector<const Measure*> chosen;
    for (const Measure& measure : frame.measures) {
        if (measure.is_usual(scale) == are_usual) {
            chosen.push_back(&measure);
        }
    }
    return chosen;
}

std::string texts_of(const std::vector<const Measure*>& measures, double scale) {
    std::vector<std::string> parts;
    parts.reserve(measures.size());
    for (const Measure* measure : measures) {
        parts.push_back(text_of(*measure, scale));
    }
    return joined(parts);
}

/// Words what would be usual if the model were scaled.
std::string as_scaled(const FrameGuess& frame) {
    return texts_of(measures_that(frame, true, frame.scale), frame.scale);
}

/// Whether it is no larger than a cupboard, and nothing tells whether it is one.
bool is_too_small(const UprightModel& upright) {
    constexpr double kLeast = 3.0;  // metres
    const scene::Bounds& bounds = upright.report.bounds;
    return !bounds.empty() && upright.frame.scale_confidence == Confidence::none &&
           (bounds.max - bounds.min).maxCoeff() < kLeast;
}

/// Whether it is higher than any building and no landscape, and nothing tells whether it is one.
bool is_too_high(const UprightModel& upright) {
    constexpr double kMost = 300.0;  // metres
    constexpr double kSteep = 0.5;   // of its width
    const scene::Bounds& bounds = upright.report.bounds;
    const Eigen::Vector3d size = bounds.max - bounds.min;
    return !bounds.empty() && upright.frame.scale_confidence == Confidence::none && size.y() > kMost &&
           size.y() > kSteep * std::max(size.x(), size.z());
}

}  // namespace

std::string size_text(const Eigen::Vector3d& size, int digits) {
    return engine::fixed(size.x(), digits) + " x " + engine::fixed(size.y(), digits) + " x " +
           engine::fixed(size.z(), digits) + " m";
}

const char* name_of(UpVote::Kind kind) {
    switch (kind) {
        case UpVote::Kind::facing:
            return "facing";
        case UpVote::Kind::risers:
            return "risers";
        case UpVote::Kind::doors:
            return "doors";
    }
    return "";
}

const char* name_of(scene::Confidence confidence) {
    switch (confidence) {
        case scene::Confidence::sure:
            return "sure";
        case scene::Confidence::unsure:
            return "unsure";
        case scene::Confidence::none:
            return "none";
    }
    return "";
}

std::vector<std::string> frame_lines(const UprightModel& upright) {
    const FrameGuess& frame = upright.frame;
    const std::string scale = "`scale: " + scene::short_number(upright.file.scale) + "`";
    std::vector<std::string> lines;
    if (upright.is_turned) {
        lines.push_back("+Z is up, so it is read with `up: z`: " + votes_for(frame, scene::UpAxis::z));
    } else if (frame.up_confidence == Confidence::none) {
        lines.push_back("nothing tells which axis is up; it is read with `up: " + name_of(upright.file.up) +
                        "`");
    } else if (frame.up == scene::UpAxis::y && frame.up_confidence == Confidence::sure) {
        lines.push_back("+Y is up: " + votes_for(frame, scene::UpAxis::y));
    }
    if (upright.is_scaled) {
        lines.push_back("it is read with " + scale + ", so that " + as_scaled(frame));
    } else if (frame.scale_confidence == Confidence::none) {
        lines.push_back("nothing tells its unit; it is read with " + scale);
    } else if (frame.scale == 1.0) {
        lines.push_back("sizes are usual: " + texts_of(measures_that(frame, true, 1.0), 1.0));
    }
    return lines;
}

std::vector<scene::ModelLint> frame_lints(const UprightModel& upright) {
    const FrameGuess& frame = upright.frame;
    std::vector<scene::ModelLint> lints;
    const bool is_contradicted = frame.up == scene::UpAxis::z && !upright.is_turned;
    if (is_contradicted || frame.up_confidence == Confidence::unsure) {
        const std::string for_z = votes_for(frame, scene::UpAxis::z);
        const std::string for_y = votes_for(frame, scene::UpAxis::y);
        const char* other = upright.file.up == scene::UpAxis::y ? "`up: z`" : "`up: y`";
        lints.push_back({"z-up", std::string(frame.up == scene::UpAxis::z ? "it seems to lie on its back: "
                                                                          : "it may lie on its back: ") +
                                     for_z + (for_y.empty() ? "" : ", but " + for_y) + "; " + other +
                                     " would turn it"});
    }
    if (is_too_small(upright) || is_too_high(upright)) {
        const int digits = is_too_high(upright) ? 0 : 3;
        lints.push_back(
            {"odd-scale",
             "it is " + size_text(upright.report.bounds.max - upright.report.bounds.min, digits) +
                 " large, " +
                 (is_too_high(upright) ? "higher than buildings are" : "too small to walk about in") +
                 ", and nothing tells its unit; it is read with " + scene::short_number(upright.file.scale)});
    }
    if (frame.scale != 1.0 && !upright.is_scaled) {
        const std::string scale = scene::short_number(upright.file.scale * frame.scale);
        lints.push_back({"odd-scale", texts_of(measures_that(frame, false, 1.0), 1.0) +
                                          ", which is unusual; with `scale: " + scale + "` " +
                                          as_scaled(frame) + "; it is read with " +
                                          scene::short_number(upright.file.scale)});
    }
    return lints;
}

}  // namespace campuswalk::tools
