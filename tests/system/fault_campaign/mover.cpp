#include "tests/system/fault_campaign/mover.hpp"

#include <algorithm>
#include <cmath>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/motion.hpp"

namespace markservo::campaign {
namespace {

// The mover that lives while commands are gone through in the order of time.
class MoverOfTheMoment {
 public:
  explicit MoverOfTheMoment(const Timeline& timeline) : truth_(timeline.base_truth), next_(truth_.begin()) {}

  void go_to(std::int64_t t) {
    for (; next_ != truth_.end() && next_->t <= t; ++next_) {
      now_ = next_->message.utime;
      session_ = next_->message.session;
    }
  }
  std::int64_t now() const { return now_; }          // us, its own time; 0: it has told none
  std::int64_t session() const { return session_; }  // 0: likewise

 private:
  const Stream<SimBaseTruth>& truth_;
  Stream<SimBaseTruth>::const_iterator next_;
  std::int64_t now_ = 0;
  std::int64_t session_ = 0;
};

// One channel's writer, as a mover keeps account of it.
class Writer {
 public:
  Writer(const Bars& bars, Commands& commands) : bars_(bars), commands_(commands) {}

  // `now`: us, the mover's time; `age`: s, of what it answers then.
  void offer(const OfferedCommand& command, std::int64_t now, double age, bool own_session) {
    const bool clear = command.meant && age <= bars_.command_age - bars_.doubt;
    if (command.session != holder_ && holder_ != 0 &&
        std::abs(seconds_between(heard_at_, now)) <= bars_.command_age - bars_.doubt) {
      if (clear && other_.session != command.session) other_ = command;
      return;
    }
    if (command.session != holder_) begin(command.session);
    const bool above = command.seq > last_.seq;
    const bool later = command.stamp > last_.stamp;
    if (!above && !later) {  // comes late, or twice
      late(command);
      return;
    }
    late_in_a_row_ = 0;
    heard_at_ = now;
    if (!above) {
      // Two of one session. It is the trial's doing if one of the two was its own.
      if (clear && (command.foreign || last_.foreign) && last_.meant) conflict(command, command.session);
      last_ = command;
      return;
    }
    last_ = command;
    if (other_.session != 0 && command.stamp > other_.stamp) {
      if (clear && (command.foreign || other_.foreign)) conflict(command, other_.session);
      return;
    }
    // What somebody says under a session of the stack's own is never the stack's.
    if ((command.foreign && own_session) || !command.can_move) return;
    commands_.fresh.push_back(command.world);
    if (command.foreign) commands_.strangers.push_back(command.world);
  }
  // What was said before is settled by a reset.
  void settle() { other_ = OfferedCommand{}; }

 private:
  void begin(std::int64_t session) {
    holder_ = session;
    last_ = OfferedCommand{};
    other_ = OfferedCommand{};
  }
  // Three in a row that grow in both are a stream that began anew.
  void late(const OfferedCommand& command) {
    constexpr int kAnew = 3;
    const bool grows = command.seq > last_late_.seq && command.stamp > last_late_.stamp;
    late_in_a_row_ = grows ? late_in_a_row_ + 1 : 1;
    last_late_ = command;
    if (late_in_a_row_ >= kAnew) last_ = command;
  }
  void conflict(const OfferedCommand& command, std::int64_t second) {
    commands_.conflicts.push_back({command.t, command.world, holder_, second});
  }

  const Bars& bars_;
  Commands& commands_;
  std::int64_t holder_ = 0;
  std::int64_t heard_at_ = 0;
  OfferedCommand last_;
  OfferedCommand last_late_;
  int late_in_a_row_ = 0;
  OfferedCommand other_;  // who spoke beside it; session 0: nobody
};

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool all_within(const std::vector<double>& values, const std::vector<double>& low, const std::vector<double>& high) {
  constexpr double kRounding = 1e-6;
  if (values.size() != high.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= low[i] - kRounding && values[i] <= high[i] + kRounding)) return false;
  }
  return true;
}

bool is_meant(const JointCommand& command, const Bars& bars) {
  constexpr double kWidest_m = 0.06;
  constexpr double kForce_N = 100.0;
  const std::vector<double> none(bars.joint_speed.size(), 1e-3);
  return command.session > 0 && command.seq > 0 && command.frame_session > 0 && command.frame_seq > 0 &&
         command.utime == command.frame_utime && all_within(command.position, bars.joint_min, bars.joint_max) &&
         all_within(command.speed_limit, none, bars.joint_speed) && command.gripper_opening >= 0.0 &&
         command.gripper_opening <= kWidest_m && command.gripper_force > 0.0 && command.gripper_force <= kForce_N;
}

bool leaps(const JointCommand& command, const ShaftsAround& shafts, std::int64_t t, const Bars& bars) {
  for (std::size_t i = 0; i < command.position.size() && i < bars.joint_speed.size(); ++i) {
    double lead = 0.0;
    if (!shafts.distance(t, i, command.position[i], lead)) continue;
    const double speed = std::min(command.speed_limit[i], bars.joint_speed[i]);
    if (lead > bars.lead_time * speed + bars.lead_rad + bars.lead_doubt) return true;
  }
  return false;
}

// The device's releases, us.
std::vector<std::int64_t> releases_of(const Timeline& timeline, const std::string& device) {
  std::vector<std::int64_t> times;
  bool latched = true;
  for (const auto& heard : timeline.stop_states) {
    const StopState& state = heard.message;
    if (heard.foreign || state.device != device || !timeline.is("simulator", state.session)) continue;
    if (latched && !state.latched) times.push_back(heard.t);
    latched = state.latched != 0;
  }
  return times;
}

}  // namespace

double base_braking(const SimBaseTruth& truth, const Bars& bars) {
  return std::max(std::abs(truth.speed) / bars.base_deceleration, std::abs(truth.turn_rate) / bars.turn_deceleration) +
         bars.base_settles;
}

std::vector<OfferedCommand> offered_to_arm(const Timeline& timeline, const Bars& bars) {
  const ShaftsAround shafts(timeline);
  std::vector<OfferedCommand> offered;
  for (const auto& heard : timeline.joint_commands) {
    const JointCommand& command = heard.message;
    const bool numbers = finite(command.position) && finite(command.speed_limit);
    offered.push_back({heard.t, heard.world, command.session, command.seq, command.frame_utime, command.joint_session,
                       heard.foreign, is_meant(command, bars), numbers && !leaps(command, shafts, heard.t, bars)});
  }
  return offered;
}

std::vector<OfferedCommand> offered_to_base(const Timeline& timeline, const Bars& bars) {
  std::vector<OfferedCommand> offered;
  for (const auto& heard : timeline.base_commands) {
    const BaseCommand& command = heard.message;
    const bool numbers = std::isfinite(command.speed) && std::isfinite(command.turn_rate);
    const bool meant = command.session > 0 && command.seq > 0 && command.odometry_seq > 0 &&
                       std::abs(command.speed) <= bars.base_speed && std::abs(command.turn_rate) <= bars.base_turn_rate;
    offered.push_back({heard.t, heard.world, command.session, command.seq, command.utime, command.odometry_session,
                       heard.foreign, meant, numbers});
  }
  return offered;
}

bool moved_by_a_stranger(const Commands& commands, double from, double to, double moment, const Bars& bars) {
  const auto at = std::lower_bound(commands.strangers.begin(), commands.strangers.end(), from - moment);
  if (at != commands.strangers.end() && *at <= to) return true;
  double last = -1e9;
  for (const TwoWriters& two : commands.conflicts) {
    const bool first = two.world - last > bars.alone;  // what goes on is known by then
    last = two.world;
    if (first && from <= two.world + bars.latch_time + moment && to >= two.world - bars.command_age) return true;
  }
  return false;
}

Commands judged_as_the_mover(const Timeline& timeline, const std::vector<OfferedCommand>& offered, const char* device,
                             const Bars& bars) {
  const std::vector<std::int64_t> releases = releases_of(timeline, device);
  const std::string writer = std::string(device) == "arm" ? "visual-servo" : "base-navigator";
  auto release = releases.begin();
  Commands commands;
  MoverOfTheMoment mover(timeline);
  Writer account(bars, commands);
  for (const OfferedCommand& command : offered) {
    for (; release != releases.end() && *release <= command.t; ++release) account.settle();
    mover.go_to(command.t);
    if (mover.now() == 0 || command.made_for != mover.session()) continue;
    const double age = seconds_between(command.stamp, mover.now());
    if (age > bars.command_age + bars.truth_period || age < -bars.doubt) continue;
    account.offer(command, mover.now(), age, timeline.is(writer, command.session));
  }
  return commands;
}

}  // namespace markservo::campaign
