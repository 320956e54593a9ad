// Faults of disks and sensors.

#include <sys/mount.h>

#include <filesystem>
#include <fstream>
#include <markservo/SimControl.hpp>

#include "common/bus/session.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// A small disk of its own under a folder of the trial's; full, or not to be written, for a while.
class Disk : public Fault {
 public:
  using Fault::Fault;
  ~Disk() override {
    if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
  }
  std::string describe() const override {
    return text("the disk of the %s is %s for %.1f s", plan().service.c_str(), full() ? "full" : "read-only",
                plan().duration);
  }
  std::set<std::string> words() const override { return {"disk"}; }
  bool ends_recording() const override { return plan().service == "recording"; }
  void prepare(Bench& bench, StackSetup&) override {
    folder_ = bench.folders().out + "/" + plan().service;
    std::filesystem::create_directories(folder_);
    const char* size = plan().service == "recording" ? "size=96m" : "size=4m";
    mounted_ = mount("campaign", folder_.c_str(), "tmpfs", 0, size) == 0;
  }
  void strike(Bench&) override {
    if (!mounted_) return;
    if (!full()) {
      struck_ = mount("campaign", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
      return;
    }
    std::ofstream fill(folder_ + "/fill", std::ios::binary);
    const std::string block(65536, 'x');
    while (fill.write(block.data(), static_cast<std::streamsize>(block.size())) && fill.flush()) {
    }
    struck_ = std::filesystem::space(folder_).available < block.size();
  }
  void end(Bench&) override {
    if (!mounted_) return;
    if (!full()) {
      mount("campaign", folder_.c_str(), "tmpfs", MS_REMOUNT, nullptr);
    } else {
      std::filesystem::remove(folder_ + "/fill");
    }
  }
  std::string evidence() const override {
    return struck_ ? (full() ? "nothing more could be written" : "it was mounted read-only") : "";
  }

 private:
  bool full() const { return plan().kind == "disk-full"; }
  std::string folder_;
  bool mounted_ = false;
  bool struck_ = false;
};

// A sensor that says what is not so; a setting of the simulator.
class LyingSensor : public Fault {
 public:
  using Fault::Fault;
  std::string describe() const override {
    return text("%s=%.0f for %.1f s", plan().variant.c_str(), plan().amount, plan().duration);
  }
  std::set<std::string> words() const override {
    // A sensor's channel, and what it shows.
    if (plan().variant == "faults.frozen_camera") return {"STEREO_FRAME", "TARGET_POSE", "mark", "sight"};
    if (plan().variant == "faults.frozen_joint") return {"JOINT_STATE", "joint"};
    return {"WHEEL_ODOMETRY", "ROBOT_POSE", "encoder"};
  }
  void strike(Bench& bench) override { ask(bench, plan().amount); }
  void end(Bench& bench) override { ask(bench, 0.0); }
  void attend(Bench& bench) override {
    if (!pending_ || Bench::now() < next_) return;
    const SimTruth& truth = bench.truth();
    if (truth.control_session == control_.session && truth.control_id == control_.control_id) {
      pending_ = false;
      if (truth.control_error.empty()) evidence_ = "the simulator obeyed";
      return;
    }
    next_ = Bench::now() + 200'000;
    bench.send("SIM_CONTROL", encoded(control_));
  }
  std::string evidence() const override { return evidence_; }

 private:
  void ask(Bench& bench, double value) {
    control_ = SimControl{};
    control_.kind = SimControl::SET;
    control_.utime = world_now(bench);
    control_.session = session_;
    control_.control_id = ++number_;
    control_.num_parameters = 1;
    control_.parameters.resize(1);
    control_.parameters[0].name = plan().variant;
    control_.parameters[0].value = value;
    pending_ = true;
    next_ = 0;
  }

  SimControl control_{};
  std::int64_t session_ = bus::random_session();
  std::int64_t number_ = 0;
  bool pending_ = false;
  std::int64_t next_ = 0;
  std::string evidence_;
};

}  // namespace

std::unique_ptr<Fault> make_device_fault(const FaultPlan& plan) {
  if (plan.kind == "disk-full" || plan.kind == "read-only") return std::make_unique<Disk>(plan);
  if (plan.kind == "lying-sensor") return std::make_unique<LyingSensor>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
