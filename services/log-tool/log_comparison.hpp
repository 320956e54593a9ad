#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/logs/log_event.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::log_tool {

struct ComparisonParameters {
  // Numbers differ when they are further apart than this, and than this part of the larger one. SI units: a micrometre,
  // a microradian; far above what another processor's rounding does, far below what a person could see.
  double tolerance = 1e-6;
  // s after a channel's first recorded message: what was recorded by then may answer what the log does not have.
  double start_up = 1.0;
};

struct FieldDifference {
  std::string channel;
  std::int64_t utime = 0;  // us, the message's
  std::string field;       // "marks[0].p_C.x"; empty: one of the messages is missing
  std::string recorded;
  std::string replayed;
};

// How the messages of one channel of a replay compare with those recorded. Who wrote a message (session, seq) does not
// count.
struct ChannelComparison {
  std::int64_t equal = 0;
  std::int64_t within = 0;  // not equal, but within the tolerance
  std::int64_t different = 0;
  std::int64_t missing = 0;  // recorded, not replayed
  std::int64_t outside = 0;  // recorded before the replay's first message, within start_up: no difference
  std::int64_t extra = 0;    // replayed, not recorded: the live service skipped the input, or the logger lost it
  double largest = 0.0;      // the largest difference between two numbers
  std::string largest_field;

  // A channel of which nothing could be compared is not.
  bool as_recorded() const { return different == 0 && missing == 0 && equal + within > 0; }
  bool complete() const { return as_recorded() && extra == 0 && outside == 0; }
};

struct LogComparison {
  std::map<std::string, ChannelComparison> channels;  // those that the replay wrote
  std::optional<FieldDifference> first;               // in the replay's order

  // Every channel is, and there is one.
  bool as_recorded() const;
  // Each message has its counterpart, too.
  bool complete() const;
};

LogComparison compare(const std::vector<logs::LogEvent>& recorded, const std::vector<logs::LogEvent>& replayed,
                      const reflection::TypeCatalog& catalog, const ComparisonParameters& parameters);

}  // namespace markservo::log_tool
