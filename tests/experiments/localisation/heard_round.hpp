#pragma once

#include <cstdint>

#include "services/rfid-localizer/localizer.hpp"
#include "services/simulator/readers/rfid_reader_model.hpp"

namespace markservo::experiments {

// What the localizer's core is told of a simulated round; `session` is the reader's driver's.
inline rfid_localizer::TagRound heard(const simulator::TagRound& round, std::int64_t session) {
  rfid_localizer::TagRound result{round.utime, session, round.window_start, round.window_end, round.window_known, {}};
  for (const simulator::TagHit& hit : round.hits) {
    result.reads.push_back({hit.uid, {}});
    if (hit.read_time_known) result.reads.back().read_utime = hit.read_utime;
  }
  return result;
}

}  // namespace markservo::experiments
