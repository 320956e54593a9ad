#pragma once

#include <cstddef>

#include "services/mmi/log/log_index.hpp"
#include "services/mmi/world/narrator_reader.hpp"

namespace markservo::mmi {

// What happened in a whole log, found out bit by bit beside other work.
class LogStoryReader {
 public:
  // `index` must outlive this.
  LogStoryReader(const LogIndex& index, const robot::RobotDescription& robot, const text::TypedCommand& typed);

  // Reads up to `events` more. False when there are none.
  bool read(std::size_t events);
  const EventLog& events() const { return narrator_.events(); }

 private:
  void pass_silence(std::int64_t from, std::int64_t to);

  const LogIndex& index_;
  NarratorReader narrator_;
  std::size_t read_ = 0;
};

}  // namespace markservo::mmi
