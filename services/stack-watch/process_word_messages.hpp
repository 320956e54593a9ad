#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "services/stack-watch/process_watch.hpp"

namespace markservo::stack_watch {

enum class Telling { kAll, kChangedState };

// PROCESS_STATUS of each process, as datagrams.
class ProcessWordMessages {
 public:
  // `robot`: prefix of the channel.
  explicit ProcessWordMessages(const std::string& robot);

  // Those of `telling`, at `wall_us`, wall clock.
  std::vector<std::vector<std::uint8_t>> next(const StackFindings& found, Telling telling, std::int64_t wall_us);

 private:
  struct Told {
    ProcessState state;
    int pid;
  };

  std::vector<std::uint8_t> datagram(const ProcessWord& word, std::int64_t wall_us);

  ProcessWatch watch_;
  std::map<std::string, Told> told_;  // by name
  std::string channel_;
  std::string host_;
  std::int64_t session_;
  std::int64_t seq_ = 0;
};

}  // namespace markservo::stack_watch
