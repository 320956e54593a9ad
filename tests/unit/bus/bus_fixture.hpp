#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServiceStatus.hpp>
#include <string>
#include <vector>

#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::bus {

// One bus on memq://, which hears what it sends itself.
class BusTest : public ::testing::Test {
 protected:
  static BusParameters parameters(const std::string& robot = {}) {
    BusParameters result = memq_parameters("test");
    result.robot = robot;
    return result;
  }

  static JointState joint_state(std::int64_t utime) {
    JointState state{};
    state.utime = utime;
    return state;
  }

  // What SERVICE_STATUS says of the only subscribed channel.
  static ChannelStatus only_channel(const Bus& bus) { return bus.status().channels.at(0); }
};

}  // namespace markservo::bus
