#pragma once

// What one trial left behind: everything heard on the bus but pictures, what the trial itself sent, and facts about
// processes. A folder on disk, so that the same history can be judged again.
//
//   DIR/history.lcm   an LCM log. Event time: us of the trial's own clock, when it was heard. Messages above kWholeSize
//                     are cut to their first kCutSize bytes, their channel then reads "CUT:<bytes>:<channel>"; what the
//                     trial sent reads "SENT:<channel>", before what was heard of it.
//   DIR/facts.jsonl   one JSON object a line: {"t": us, "kind": "process" | "phase" | "fault" | ...}
//   DIR/printed/      what services logged and scripts printed

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace markservo::campaign {

inline constexpr std::size_t kWholeSize = 16384;
inline constexpr std::size_t kCutSize = 256;

struct Event {
  std::int64_t t = 0;  // us, when it was heard
  std::string channel;
  std::int64_t size = 0;  // bytes of the message, all of it
  std::vector<std::uint8_t> data;
  bool foreign = false;  // the trial's own, not the stack's

  bool whole() const { return static_cast<std::int64_t>(data.size()) == size; }
};

struct History {
  std::vector<Event> events;  // in the order in which they were heard
  std::vector<nlohmann::json> facts;
  std::map<std::string, std::string> printed;  // by file name
};

// How the trial's own messages are told from the stack's: the first one heard after it was sent, with its bytes.
void mark_foreign(const std::vector<Event>& sent, std::vector<Event>& heard);

// Throws std::runtime_error if `folder` has no readable history.
History load_history(const std::string& folder);

// Writes the first two of a history's files as the trial goes on.
class HistoryWriter {
 public:
  // Throws std::runtime_error if they cannot be written.
  explicit HistoryWriter(const std::string& folder);

  void heard(std::int64_t t, const std::string& channel, std::int64_t size, const std::uint8_t* data,
             std::size_t available);
  void sent(std::int64_t t, const std::string& channel, const std::vector<std::uint8_t>& data);
  // `fact` gets its time.
  void fact(std::int64_t t, nlohmann::json fact);

 private:
  void write(std::int64_t t, const std::string& prefix, const std::string& channel, std::int64_t size,
             const std::uint8_t* data, std::size_t available);

  std::unique_ptr<lcm::LogFile> log_;
  std::shared_ptr<std::FILE> facts_;
  std::int64_t number_ = 0;
};

}  // namespace markservo::campaign
