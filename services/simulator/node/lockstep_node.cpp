#include "services/simulator/node/lockstep_node.hpp"

#include <chrono>
#include <cstdint>

#include "common/logging/log.hpp"
#include "services/simulator/node/answer_wait_node.hpp"
#include "services/simulator/node/world_node.hpp"

namespace markservo::simulator {
namespace {

class Lockstep {
 public:
  Lockstep(bus::Bus& bus, WorldNode& world, double timeout_s) : bus_(&bus), world_(&world), timeout_s_(timeout_s) {}

  void run();

 private:
  // Until all awaited channels answered, the wait timed out, or the world was reset. False when the service shall end.
  bool answered(AnswerWait& wait, const LockstepBarrier& barrier, const char* what);
  bool was_reset() const { return world_->run().resets != resets_before_wait_; }

  bus::Bus* bus_;
  WorldNode* world_;
  double timeout_s_;
  std::int64_t resets_before_wait_ = 0;
  AnswerWait frame_wait_{[this] { world_->expose_frame(); }, [this] { return was_reset(); }};
  AnswerWait odometry_wait_{[this] { world_->repeat_odometry(); }, [this] { return was_reset(); }};
};

void Lockstep::run() {
  while (true) {
    const std::int64_t resets = world_->run().resets;
    if (world_->publish_base() && !answered(odometry_wait_, world_->odometry_barrier(), "an odometry")) return;
    if (resets != world_->run().resets) continue;
    if (!world_->frame_due()) {
      world_->step();
      continue;
    }
    world_->expose_frame();
    const bool lost = world_->simulation().dropped();
    if (!lost && !answered(frame_wait_, world_->frame_barrier(), "a frame")) return;
    if (lost && !bus_->poll(std::chrono::milliseconds(0))) return;
    if (resets == world_->run().resets) world_->step();
  }
}

bool Lockstep::answered(AnswerWait& wait, const LockstepBarrier& barrier, const char* what) {
  resets_before_wait_ = world_->run().resets;
  const AnswerWait::Outcome outcome = wait.run(*bus_, barrier, timeout_s_);
  if (outcome == AnswerWait::Outcome::kTimedOut) {
    if (world_->run().valid) {
      logging::error("{}, {} us after the epoch: no answer on {} within {} s: this run is invalid until the next RESET",
                     what, world_->simulation().elapsed_us(), barrier.missing(), timeout_s_);
    }
    world_->invalidate();
  }
  return outcome != AnswerWait::Outcome::kEnded;
}

}  // namespace

void run_lockstep(bus::Bus& bus, WorldNode& world, double timeout_s) {
  Lockstep(bus, world, timeout_s).run();
}

}  // namespace markservo::simulator
