#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServiceStatus.hpp>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"

namespace markservo::bus {

// One bus on memq://, which hears what it sends itself.
class BusTest : public ::testing::Test {
 protected:
  static BusParameters parameters(const std::string& robot = {}) {
    BusParameters result;
    result.urls = {"memq://", "memq://"};
    result.service_name = "test";
    result.robot = robot;
    result.heartbeat = false;
    return result;
  }

  static JointState joint_state(int64_t utime) {
    JointState state{};
    state.utime = utime;
    return state;
  }

  // Handles all that waits.
  static void settle(Bus& bus) {
    for (int i = 0; i < 5; ++i) bus.poll(std::chrono::milliseconds(0));
  }

  // What SERVICE_STATUS says of the only subscribed channel.
  static ChannelStatus only_channel(const Bus& bus) { return bus.status().channels.at(0); }
};

}  // namespace markservo::bus
