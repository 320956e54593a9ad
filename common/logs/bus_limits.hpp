#pragma once

#include <cstddef>

namespace markservo::logs {

inline constexpr std::size_t kLongestLcmChannel = 63;  // bytes; longer names LCM does not send

// Bytes of a message. LCM sends all packets of a message at once, and a reader's socket holds twice the receive buffer
// that it may have at most: with 4 MiB, our own services' and the usual limit, 8 MB came whole five times of five, 12
// MB never, and what was sent with them suffered too (measured with LCM 1.3.1 on Debian 12).
inline constexpr std::size_t kLargestByUdp = 8'000'000;

}  // namespace markservo::logs
