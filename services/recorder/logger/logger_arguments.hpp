#pragma once

// What lcm-logger is told.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/recorder/recording_plan.hpp"

namespace markservo::recorder {

// The URL as lcm-logger needs it: with the kernel's default receive buffer raw frames are lost.
std::string with_receive_buffer(const std::string& lcm_url);

// The receive buffer that the URL asks for, bytes.
std::optional<std::int64_t> asked_receive_buffer(const std::string& lcm_url);

// A bus's multicast group; nothing for a bus that has none.
std::optional<std::string> multicast_group(const std::string& lcm_url);

// The channels to record, as a regular expression of the whole name. Frames that no one asked for are not even put
// together; what recorders say of themselves stands in the manifest.
std::string channel_expression(bool frames, const std::string& robot);

// How much it may keep in memory while the disk is slow, MB: a quarter of what is free, from 100 to 1000.
std::int64_t unwritten_megabytes(std::int64_t available_memory_kib);

// Its arguments, to write `path`.
std::vector<std::string> logger_arguments(const RecordingPlan& plan, std::int64_t available_memory_kib,
                                          const std::string& path);

}  // namespace markservo::recorder
