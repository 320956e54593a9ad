#pragma once

namespace markservo::recorder {

inline constexpr const char* kLcmLogger = "lcm-logger";
inline constexpr const char* kKeepLogger =
    "keep-logger";  // this program's first argument, where it shall run lcm-logger

}  // namespace markservo::recorder
