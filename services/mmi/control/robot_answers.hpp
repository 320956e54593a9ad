#pragma once

// What is known of those who would obey, and so why a wish cannot work now. No bus, no clock: `now` is s of any steady
// clock.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/task/dialogue.hpp"

namespace markservo::mmi {

class RobotAnswers {
 public:
  // `stop_devices` as in robot.yaml; `drives`: it has a base.
  RobotAnswers(const std::vector<std::string>& stop_devices, bool drives);

  // `asked`: its stop answers somebody's request, rather than being the state in which it came up.
  void observe(const task::StopReport& report, bool asked, double now);
  void observe(const task::TaskReport& report, double now);
  // Two write TASK_STATE, in words; that holds until kDeviceSilence has passed without it.
  void observe_conflict(const std::string& words, double now);

  // Tells a new dialogue what is known, so that it need not wait for the next words.
  void tell(task::Dialogue& dialogue, double now) const;

  // A sentence with the remedy; empty when `action` can be sent.
  std::string why_not(task::Action action, double now) const;

 private:
  struct Device {
    std::optional<task::StopReport> report;
    bool asked = false;
    double heard = 0.0;
  };

  std::string silent_devices(double now) const;
  std::string why_no_motion(double now) const;
  std::string why_no_reset() const;
  std::string why_no_abort(double now) const;
  bool task_is_silent(double now) const;

  bool drives_;
  std::map<std::string, Device> devices_;
  std::optional<task::TaskReport> task_;
  double task_heard_ = 0.0;
  std::string two_;
  double two_heard_ = 0.0;
};

}  // namespace markservo::mmi
