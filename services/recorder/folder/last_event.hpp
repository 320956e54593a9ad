#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace markservo::recorder {

// So much of a log's end is looked at, bytes: more than its longest event, a raw frame of 1.8 MB.
inline constexpr std::size_t kLogEnd = 4'000'000;

// When the last event that begins within `end`, the last bytes of an LCM log, was heard: us since the epoch. Nothing
// where there is none. What looks like an event within a picture has an impossible time: one that lies before the day
// that ends at `now_utime`, or behind it.
std::optional<std::int64_t> last_event_utime(std::string_view end, std::int64_t now_utime);

// Since when nothing was recorded, us since the epoch: the last event on disk, of `last_events` the first that was
// heard after an lcm-logger began to listen, at `listens_since`, or that moment. (A file's own time says only when
// something was written.)
std::int64_t missed_since(const std::vector<std::int64_t>& last_events, std::int64_t listens_since);

}  // namespace markservo::recorder
