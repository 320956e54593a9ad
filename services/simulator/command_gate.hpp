#pragma once

// Which JOINT_COMMANDs the simulated arm obeys, and which BASE_COMMANDs the base: what every driver must hold to.
// Starts latched; only a reset unlatches, and never moves anything by itself. The arm's commands answer frames, the
// base's its odometry: "frame" stands for both here. No clock: "now" is simulated time.

#include <cstdint>

namespace markservo::simulator {

inline constexpr std::int64_t kCommandTimeout_us = 300'000;  // older or missing commands stop motion

// The frame that a command answers.
struct FrameIdentity {
  std::int64_t session = 0;
  std::int64_t seq = 0;
  std::int64_t utime = 0;  // us
};

enum class CommandVerdict {
  kObeyed,
  kLatched,       // STOP holds the device
  kOtherSession,  // answers the frame of another simulator, or of an earlier run of this one
  kUnknownFrame,  // answers a frame that was not yet exposed
  kBeforeReset,   // answers a frame from before the STOP reset or the world's reset
  kOutOfOrder,    // answers the same frame as the last obeyed command, or an older one
  kStale,         // answers a frame older than 0.3 s
};

// A few words for people.
const char* describe(CommandVerdict verdict);

class CommandGate {
 public:
  explicit CommandGate(std::int64_t session) : session_(session) {}

  bool latched() const { return latched_; }
  void latch() { latched_ = true; }

  // Unlatches; only commands that answer frames after `newest_seq` count.
  void unlatch(std::int64_t newest_seq);

  // The world begins anew: latched, and nothing from before counts.
  void restart(std::int64_t newest_seq);

  // Judges a command that arrives at `now_utime`, when the newest frame is `newest_seq`.
  CommandVerdict offer(const FrameIdentity& answered, std::int64_t newest_seq, std::int64_t now_utime);

  // True if the last obeyed command is more than 0.3 s ago, or there was none since the reset.
  bool silent(std::int64_t now_utime) const;

 private:
  std::int64_t session_;
  bool latched_ = true;
  std::int64_t after_seq_ = 0;    // frames up to this one do not count
  std::int64_t last_seq_ = 0;     // the last one obeyed
  std::int64_t last_utime_ = -1;  // us, when it came; -1: none
};

}  // namespace markservo::simulator
