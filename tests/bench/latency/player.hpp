#pragma once

// Sends recorded frames into a route at a camera's rate, and notes when the answers come.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <markservo/JointState.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/channels.hpp>
#include <memory>
#include <vector>

#include "common/bus/publisher.hpp"
#include "common/robot/robot_description.hpp"
#include "tests/bench/latency/frame_ledger.hpp"
#include "tests/bench/latency/route.hpp"
#include "tests/bench/lcm_sink.hpp"

namespace markservo::bench {

// Who listens: each listener costs the others time, for all get all packets.
enum class Listening { kAnswerOnly, kEveryStage };

class Player {
 public:
  // `arm_at`: joint angles (rad) for the JOINT_STATE that goes out between two frames.
  // Throws std::runtime_error if the route's bus cannot be joined.
  Player(Route route, const robot::JointVector& arm_at);

  // Sends frames until the route answers, then a few more; the usual size of each stage's message, bytes.
  // Throws std::runtime_error that names the first stage that keeps silent.
  std::vector<std::size_t> wait_until_answered(std::vector<StereoFrame>& frames);

  // Sends `count` frames at `rate` (Hz), taking `frames` in turn from where the last call ended, and enters them and
  // what follows into `ledger`. Some that go before only wake the processes up. Ends when all are answered, or a while
  // after the last one.
  void play(std::vector<StereoFrame>& frames, double rate, int count, Listening listening, FrameLedger& ledger);

  const Route& route() const { return route_; }

 private:
  using Clock = std::chrono::steady_clock;
  // What comes in: stage, frame's seq, size in bytes.
  using Heard = std::function<void(std::size_t, std::int64_t, std::size_t)>;
  struct Ear {
    std::size_t stage = 0;
    const Stage* what = nullptr;
    Heard heard;
  };
  // A member of the bus that hears while it lives.
  struct Listener {
    std::unique_ptr<lcm::LCM> lcm;
    std::vector<std::unique_ptr<Ear>> ears;

    void listen_until(Clock::time_point end);
  };

  static void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel, Ear* ear);
  Listener listen(Listening listening, const Heard& heard) const;
  void encode_next(std::vector<StereoFrame>& frames);
  void send_frame();
  void send_joints();

  Route route_;
  lcm::LCM out_;  // only sends: a member that does not listen costs nothing
  LcmSink sink_{&out_};
  std::int64_t session_;
  bus::Publisher<JointState> joints_;
  JointState joint_state_;
  std::size_t next_frame_ = 0;
  std::int64_t seq_ = 0;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace markservo::bench
