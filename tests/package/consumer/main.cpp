// A service in a project of its own, with a type and a channel of its own.
//   in: TARGET_POSE     out: MARK_HEIGHT

#include <cmath>
#include <gauge/MarkHeight.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/common/bus/service.hpp>
#include <optional>
#include <string>

namespace markservo::messages {

// What a message must also satisfy before it is worked on or sent.
template <>
struct MessageRules<gauge::MarkHeight> {
  static std::string violation(const gauge::MarkHeight& height) {
    return std::isfinite(height.p_C.z) ? "" : "p_C.z is no number; allowed: m";
  }
};

}  // namespace markservo::messages

namespace {

const markservo::channels::Channel<gauge::MarkHeight> kMarkHeight{
    markservo::channels::Entry{"MARK_HEIGHT", "MarkHeight"}};

class MarkGauge : public markservo::bus::Service {
 public:
  void add_options(CLI::App& app) override {
    markservo::bus::Options(app).option("--least", least_, "Tell of marks above this, m");
  }
  void configure(const std::string&) override {}

  void start(markservo::bus::Bus& bus) override {
    heights_ = bus.advertise(kMarkHeight);
    bus.on_latest(markservo::channels::kTargetPose, [this](const markservo::TargetPose& pose) { tell(pose); });
    bus.need(markservo::channels::kTargetPose);
  }

 private:
  void tell(const markservo::TargetPose& pose) {
    gauge::MarkHeight height{};
    height.utime = pose.utime;
    height.p_C.z = least_;
    for (const markservo::LocatedMark& mark : pose.marks) {
      if (mark.status != markservo::LocatedMark::LOCATED || mark.p_C.z <= height.p_C.z) continue;
      height.name = mark.name;
      height.p_C = mark.p_C;
    }
    heights_->publish(height);
  }

  double least_ = -10.0;
  std::optional<markservo::bus::Publisher<gauge::MarkHeight>> heights_;
};

}  // namespace

int main(int argc, char** argv) {
  MarkGauge gauge;
  return markservo::bus::run_service({"mark-gauge", "Tells the highest mark (TARGET_POSE in, MARK_HEIGHT out)"}, gauge,
                                     argc, argv);
}
