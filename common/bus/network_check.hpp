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

// Why raw frames do not arrive whole through `url`'s transport, and what mends it, in one line; empty if they do: by
// memq and file always, by udpm if both the URL's recv_buf_size and what the kernel grants are large enough.
// `grantable`: the most that the kernel grants, bytes.
std::string raw_frames_obstacle(const std::string& url, std::optional<std::int64_t> grantable);
// Likewise, by what this kernel grants.
std::string raw_frames_obstacle(const std::string& url);
bool raw_frames_fit(const std::string& url);

// What is to be said where frames go as JPEG because of raw_frames_obstacle().
std::string jpeg_notice(const std::string& obstacle);

// The commands that give a host without one a multicast route.
std::string multicast_route_advice();

}  // namespace markservo::bus
