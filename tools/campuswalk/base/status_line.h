#pragma once

#include <string>

namespace campuswalk::tools {

/// A line on a terminal's standard error that says how far something is, and is erased again.
class StatusLine {
public:
    /// Without a terminal it prints nothing.
    explicit StatusLine(bool enabled) : enabled_(enabled) {}
    ~StatusLine() { hide(); }
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// In place of what is shown.
    void show(const std::string& text);
    /// To be called before anything else is printed.
    void hide();
    bool is_shown() const { return shown_; }

private:
    bool enabled_;
    bool shown_ = false;
};

}  // namespace campuswalk::tools
