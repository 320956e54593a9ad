#pragma once

// The simulated base on the bus: RFID_TAG_HITS, SONAR_SCAN, SIM_BASE_TRUTH and WHEEL_ODOMETRY out, in that order where
// they fall together; BASE_COMMAND in.

#include <cstdint>
#include <markservo/BaseCommand.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"
#include "services/simulator/faults/sensor_faults.hpp"
#include "services/simulator/time/lockstep_barrier.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

class BaseNode {
 public:
  // `simulation` has a base and outlives this. In lockstep `awaited`, channels that answer odometries, must answer each
  // odometry.
  BaseNode(bus::Bus& bus, Simulation& simulation, const std::vector<std::string>& awaited);
  BaseNode(const BaseNode&) = delete;
  BaseNode& operator=(const BaseNode&) = delete;

  // Sends what has become due. True if that was an odometry.
  bool publish_due();
  // Sends the newest odometry again under another number, with what belongs to it: nobody was there to answer.
  void repeat();

  // Whether the awaited channels have answered the newest odometry.
  const LockstepBarrier& barrier() const { return barrier_; }

 private:
  void on_command(const BaseCommand& message);
  void publish_odometry();

  Simulation* simulation_;
  LockstepBarrier barrier_;
  bus::Publisher<RfidTagHits> rounds_;
  bus::Publisher<SonarScan> scans_;
  bus::Publisher<SimBaseTruth> truths_;
  bus::Publisher<WheelOdometry> odometries_;
  SensorFaults faults_;
  std::optional<SonarScan> scan_;          // the newest
  std::optional<WheelOdometry> odometry_;  // the newest
  std::int64_t odometry_seq_ = 0;
};

}  // namespace markservo::simulator
