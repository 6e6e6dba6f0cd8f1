// What the program's exit code says.
#pragma once

inline constexpr int exit_answered = 0;
inline constexpr int exit_unanswered = 1;   // understood but without answer, or an answer that failed its check
inline constexpr int exit_wrong_input = 2;  // a problem file or a command line that cannot be understood
inline constexpr int exit_internal = 3;     // a fault of the program or of the machine
inline constexpr int exit_interrupted = 130;
