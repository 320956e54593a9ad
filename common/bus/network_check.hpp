#pragma once

// What the host's network settings allow, found out before they hurt.

#include <cstdint>
#include <optional>
#include <string>

namespace markservo::bus {

// Raw 640 x 480 pairs (1.84 MB) arrive whole with a receive buffer of this size; below it 60 to 98% are lost.
inline constexpr std::int64_t kReceiveBufferForRawFrames = 2'000'000;  // bytes

// The receive buffer in bytes that a socket gets which asks for `asked`: the kernel clamps silently to
// net.core.rmem_max, which a network namespace hides but still obeys. Nothing if no socket can be had.
std::optional<std::int64_t> granted_receive_buffer(std::int64_t asked);

// True if raw frames fit through `url`'s transport: memq and file always, udpm if both the URL's recv_buf_size and what
// the kernel grants are large enough.
bool raw_frames_fit(const std::string& url);

// The one warning line for frames that must go as JPEG.
std::string raw_frames_advice();

// The commands that give a host without one a multicast route.
std::string multicast_route_advice();

}  // namespace markservo::bus
