#pragma once

namespace campuswalk::tools {

constexpr int kPass = 0;
constexpr int kExpectationFailed = 1;
constexpr int kOverlapping = 1;  ///< of `collide`; kPass means apart
constexpr int kUnsure = 1;       ///< of `info --strict`; kPass means that nothing has to be asked
constexpr int kDifferent = 1;    ///< of commands that compare; kPass means the same
constexpr int kBadInput = 2;     ///< usage or input, found before anything ran
constexpr int kRunFailed = 3;    ///< something went wrong while running: disk full, no GL
constexpr int kNothingSelected = 5;
constexpr int kInterrupted = 130;

}  // namespace campuswalk::tools
