#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/mmi/stop/device_silence.hpp"
#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct StopTroubleParameters {
  double silent = kDeviceSilence;  // s without STOP_STATE
  double first_word = 5.0;  // s for its first, once something that would move it speaks: drivers start at the same time
  double expects = 3.0;     // s since such a service has spoken, of once a second, after which nothing is expected
};

// stop_latched: a stop device is latched, from when it was told to, or came up so again after it had been in use. That
// all come up stopped is how a robot begins, and no trouble. stop_device_silent: one that has spoken, or that something
// here would move, says nothing.
class StopTroubles {
 public:
  explicit StopTroubles(const std::vector<std::string>& stop_devices, StopTroubleParameters parameters = {});

  // That of a device that is no stop device is passed over.
  void observe(const StopWord& word, double now);
  void observe(const ServiceWord& word, double now);

  void find(const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Device {
    std::optional<StopWord> word;  // the newest
    Since last;
    Since latched_since;
  };

  bool is_silent(const Device& device, double now) const;
  void find_silent(const std::string& name, const Device& device, const Remedies& remedies, Findings& found) const;
  void find_latched(const Remedies& remedies, double now, Findings& found) const;

  StopTroubleParameters parameters_;
  std::map<std::string, Device> devices_;
  bool in_use_ = false;                  // one was released, or told to do something
  std::optional<Since> expected_since_;  // something that moves them speaks
  double mover_heard_ = 0.0;             // s, the last time
};

}  // namespace markservo::mmi
