#pragma once

// Histories that no robot wrote: a stack at peace, to which a test adds what must be found.

#include <cstdint>
#include <map>
#include <markservo/SimBody.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/system/fault_campaign/invariants.hpp"

namespace markservo::campaign {

inline constexpr std::int64_t kBegin = 1'700'000'000'000'000;  // us
inline constexpr std::int64_t kSimulator = 101;                // sessions
inline constexpr std::int64_t kServo = 102;
inline constexpr std::int64_t kTask = 103;
inline constexpr std::int64_t kNavigator = 104;
inline constexpr std::int64_t kStranger = 999;

inline std::int64_t at(double seconds) {
  return kBegin + static_cast<std::int64_t>(seconds * 1e6);
}

// Process and session of each service of the stack.
const std::map<std::string, std::pair<int, std::int64_t>>& forged_stack();
// Limits as of a robot whose joints turn a quarter of a turn each way, at 5 rad/s.
Bars forged_bars();

// Who commands: visual-servo, or base-navigator, unless it says otherwise.
struct CommandWriter {
  std::int64_t session = kServo;
  std::int64_t made_for = kSimulator;  // the mover whose measurements it answers
  double age = 0.0;                    // s, of these
  bool foreign = false;                // the trial itself speaks, whatever the session
};

class ForgedHistory {
 public:
  // The stack's services have spoken: their sessions are known.
  ForgedHistory();

  // The world from `from` to `to` (s): shafts as `angle` says by time for all joints, base at `x`; truth at 15 Hz and
  // 50 Hz.
  template <class Angle, class Place>
  ForgedHistory& world(double from, double to, Angle angle, Place x) {
    for (double t = from; t < to; t += 0.02) base_at(t, x(t));
    for (double t = from; t < to; t += 1.0 / 15.0) arm_at(t, angle(t));
    return *this;
  }
  ForgedHistory& still(double from, double to) {
    return world(
        from, to, [](double) { return 0.0; }, [](double) { return 0.0; });
  }
  ForgedHistory& arm_at(double t, double angle, const SimBody* body = nullptr, double opening = 0.03,
                        const std::string& touched = {});
  ForgedHistory& base_at(double t, double x, bool touched = false, double heading = 0.0, double speed = 0.0);

  ForgedHistory& servo_goals(double from, double to, std::int64_t session = kTask, double stamp_off = 0.0);
  ForgedHistory& follows(double t, std::int64_t session);
  ForgedHistory& base_goals(double from, double to);
  ForgedHistory& joint_commands(double from, double to, double position = 0.0, double speed = 1.0,
                                const CommandWriter& writer = {});
  // What was said on JOINT_COMMAND so far comes once more, so many s later.
  ForgedHistory& joint_commands_again(double later);
  ForgedHistory& base_commands(double from, double to, double speed = 0.0, const CommandWriter& writer = {});
  ForgedHistory& stop_state(double t, const std::string& device, bool latched, std::int64_t request = 0);
  ForgedHistory& stop(double t, std::int64_t id);
  ForgedHistory& reset(double t, std::int64_t id, double stamped);
  ForgedHistory& task_state(double t, int state, const std::string& reason = {}, std::int64_t command = 0);
  ForgedHistory& start_command(double t, std::int64_t id, double stamped);
  // SERVICE_STATUS at 1 Hz; `received` messages more a second on `channel`.
  ForgedHistory& says(double from, double to, const std::string& service, const std::string& state,
                      const std::string& channel = {}, int received = 0);
  ForgedHistory& messages(double from, double to, const std::string& channel, double rate, std::int64_t size);
  ForgedHistory& process(double from, double to, const std::string& service, char state, double rss_mb = 50.0);
  ForgedHistory& fault(double struck, double ended, std::set<std::string> words);
  ForgedHistory& start(double t);
  ForgedHistory& ended(double t);
  // `gaps`: what its manifest tells as missed.
  ForgedHistory& recorded(const std::vector<std::pair<double, double>>& spans, double until,
                          const std::vector<std::pair<double, double>>& gaps = {},
                          const std::string& ended_by = "told to");
  ForgedHistory& printed(const std::string& name, const std::string& text);

  // In the order of time.
  History history() const;
  Timeline timeline() const { return timeline_of(history()); }

 private:
  ForgedHistory& request(double t, std::int8_t kind, std::int64_t id, double stamped);
  template <class M>
  ForgedHistory& add(double t, const std::string& channel, const M& message, bool foreign = false);

  History history_;
  std::int64_t seq_ = 0;
  std::map<std::string, std::int64_t> pids_;
  std::size_t faults_ = 0;
};

SimBody held_book(double height);

}  // namespace markservo::campaign
