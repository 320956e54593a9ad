#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/logs/log_files.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::mmi {

// A log's events by time, and where each channel's stand in it. Refers to the log's bytes.
class LogIndex {
 public:
  // Of the channels that begin with `prefix`, without it. `log` must outlive this. Throws ConfigurationError where
  // there is none.
  LogIndex(const logs::LogSet& log, const std::string& prefix, const reflection::TypeCatalog& types);

  struct Event {
    std::int64_t at = 0;  // us
    const std::string* channel = nullptr;
    logs::ByteView data;
  };

  const std::vector<Event>& events() const { return events_; }
  std::int64_t begin() const { return events_.front().at; }  // us
  std::int64_t end() const { return events_.back().at; }     // us

  // How many of the events are at `at` (us) or before.
  std::size_t count_until(std::int64_t at) const;
  // Of the first `count` events, the newest of each channel and of each of many that write on it; ascending.
  std::vector<std::size_t> newest_of(std::size_t count) const;
  // Which events are pictures; ascending.
  const std::vector<std::size_t>& pictures() const { return pictures_; }

 private:
  std::vector<std::string> names_;
  std::vector<Event> events_;
  std::map<std::pair<const std::string*, std::string>, std::vector<std::size_t>> by_source_;  // channel and key
  std::vector<std::size_t> pictures_;
};

}  // namespace markservo::mmi
