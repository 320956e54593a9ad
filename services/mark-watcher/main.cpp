// An example to copy for a service of your own: listens to TARGET_POSE and prints where each mark is.
//   in: TARGET_POSE     out: standard output, one line per mark and frame

#include <cstdio>
#include <markservo/TargetPose.hpp>

#include "common/bus/options.hpp"
#include "common/bus/service.hpp"
#include "common/messages/state_codes.hpp"
#include "common/robot/require_mark.hpp"
#include "common/states/mark_cue.hpp"
#include "common/states/mark_status.hpp"

using markservo::LocatedMark;
using markservo::TargetPose;
using markservo::messages::state_of;

namespace {

class MarkWatcher : public markservo::bus::Service {
 public:
  // Options of your own; a --config file may set them too.
  void add_options(CLI::App& app) override {
    markservo::bus::Options(app).option("--mark", only_, "Print this mark only");
  }

  // Read your files and check your settings here; throw ConfigurationError to end with exit code 2.
  void configure(const std::string& robot_file) override {
    if (only_.empty()) return;
    markservo::robot::require_mark(markservo::robot::load_robot_description(robot_file), "--mark", only_, robot_file);
  }

  // Subscribe and advertise. on_latest: the newest message wins; on_each: all, in order. need: until it comes, and when
  // it stops coming, the log and SERVICE_STATUS say so.
  void start(markservo::bus::Bus& bus) override {
    bus.on_latest(markservo::channels::kTargetPose, [this](const TargetPose& pose) { print(pose); });
    bus.need(markservo::channels::kTargetPose);
  }

 private:
  void print(const TargetPose& pose) const {
    for (const LocatedMark& mark : pose.marks) {
      if (!only_.empty() && mark.name != only_) continue;
      if (mark.status == LocatedMark::LOCATED) {
        const char* cue = name_of(state_of<markservo::MarkCue>(mark.cue));
        std::printf("%s x=%.4f m y=%.4f m z=%.4f m, %s\n", mark.name.c_str(), mark.p_C.x, mark.p_C.y, mark.p_C.z, cue);
      } else {
        std::printf("%s not located: %s\n", mark.name.c_str(), name_of(state_of<markservo::MarkStatus>(mark.status)));
      }
    }
    std::fflush(stdout);
  }

  std::string only_;
};

}  // namespace

int main(int argc, char** argv) {
  MarkWatcher watcher;
  return markservo::bus::run_service({"mark-watcher", "Prints where each mark is (TARGET_POSE)"}, watcher, argc, argv);
}
