#include "services/simulator/node/real_time_node.hpp"

#include <chrono>
#include <cstdint>

#include "common/time/clocks.hpp"
#include "services/simulator/node/world_node.hpp"
#include "services/simulator/time/real_time_pace.hpp"

namespace markservo::simulator {

void run_real_time(bus::Bus& bus, WorldNode& world) {
  using std::chrono::milliseconds;
  bus.set_state("real time");
  const Simulation& simulation = world.simulation();
  RealTimePace pace(simulation.utime(), steady_clock_us());
  while (true) {
    const std::int64_t wait_us = pace.wait(simulation.utime(), steady_clock_us());
    if (!bus.poll(std::chrono::ceil<milliseconds>(std::chrono::microseconds(wait_us)))) return;
    world.tell_of_a_latch();
    if (pace.wait(simulation.utime(), steady_clock_us()) > 0) continue;
    world.publish_base();
    if (world.frame_due()) world.expose_frame();
    // In bites of one joint state, so that commands are taken in at 100 Hz.
    do {
      world.step();
      world.publish_base();
    } while (!world.frame_due() && !world.joint_state_due());
  }
}

}  // namespace markservo::simulator
