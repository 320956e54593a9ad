#pragma once

// STOP for whoever clicks: repeated until every stop device has echoed it, or a later RESET is heard, whether the one
// who clicked is still there or not. No bus, no clock: `now` is s of any steady clock.
//
// | state        | event                                         | then                              |
// | ------------ | --------------------------------------------- | --------------------------------- |
// | idle         | request                                       | requested, under a new id         |
// | requested    | request                                       | the same request                  |
// | requested    | every stop device has echoed it               | acknowledged: nothing is due      |
// | requested    | a later RESET                                 | idle: nothing is due              |
// | requested    | a device that has echoed is released          | it has not echoed                 |
// | acknowledged | a later RESET; a device is released           | idle                              |
// | acknowledged | request                                       | requested, under a new id         |

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/motion/command_sender.hpp"
#include "common/task/dialogue.hpp"
#include "services/mmi/stop/device_silence.hpp"

namespace markservo::mmi {

struct StopParameters {
  double repeat = 0.2;   // s between two sendings: LCM may lose one
  double silent = 0.32;  // s after the request in which a device echoes (p99 0.2 s on a busy machine), or counts as
                         // silent: a person sees it 0.1 s later, and is to see it within 0.5 s
  double gone = kDeviceSilence;  // s without a word, after which a device counts as silent while nothing is asked
  double clock_jump =
      1.0;  // s by which the devices' time must fall to have begun anew: words come late and out of order
};

enum class StopAnswer { kIdle, kRequested, kAcknowledged, kSilent };

// "idle", "requested", "acknowledged", "silent".
const char* name_of(StopAnswer answer);

struct StopDeviceView {
  std::string device;
  StopAnswer answer = StopAnswer::kSilent;  // kIdle: nothing is asked of it
  std::optional<bool> latched;              // nothing before its first word
  std::string reason;                       // of its stop
};

struct StopView {
  StopAnswer state = StopAnswer::kIdle;  // never kSilent
  std::int64_t request_id = 0;           // 0: there was none
  std::vector<StopDeviceView> devices;   // as in robot.yaml's stop_devices
};

// What to send as STOP of kind STOP, under the bus's session.
struct StopToSend {
  std::int64_t request_id = 0;
  std::int64_t utime = 0;  // us; 0 while no stop device was heard
  std::string reason;
};

// RESET, whoever sent it.
struct HeardReset {
  std::int64_t session = 0;
  std::int64_t request_id = 0;
  std::int64_t utime = 0;  // us
};

class StopRequester {
 public:
  // `stop_devices` as in robot.yaml, none twice.
  explicit StopRequester(std::vector<std::string> stop_devices, StopParameters parameters = {});

  // Somebody asks for a stop; `reason` for people.
  void request(const std::string& reason, double now);
  // The STOP to send at `now`; to be called every 0.05 s or oftener, and at once after request().
  std::optional<StopToSend> due(double now);

  // A STOP_STATE of `utime` (us). report.answers_us: its request is (the bus's session, request_id()). That of a device
  // that is no stop device is passed over.
  void observe(const task::StopReport& report, std::int64_t utime, double now);
  void observe(const HeardReset& reset);

  // A number for another request of ours, RESET.
  std::int64_t number_another() { return ++numbers_; }
  // Of the newest request; 0 before the first.
  std::int64_t request_id() const { return request_id_; }
  StopView view(double now) const;

 private:
  struct Device {
    std::optional<task::StopReport> report;  // the newest
    double heard = 0.0;
    std::optional<std::int64_t> echo_utime;  // us: when it first echoed the present request
  };

  bool is_later(const HeardReset& reset) const;
  void end();
  StopAnswer answer_of(const Device& device, double now) const;

  std::vector<std::string> stop_devices_;
  StopParameters parameters_;
  motion::CommandSender sender_;
  std::map<std::string, Device> devices_;  // each of stop_devices_

  StopAnswer state_ = StopAnswer::kIdle;
  std::int64_t numbers_ = 0;  // given to requests so far
  std::int64_t request_id_ = 0;
  std::string reason_;
  std::int64_t requested_utime_ = 0;  // us, of the stop devices' time
  double requested_ = 0.0;
  std::optional<double> sent_;
  std::deque<std::pair<std::int64_t, std::int64_t>> earlier_resets_;  // session and id of those heard last
};

}  // namespace markservo::mmi
