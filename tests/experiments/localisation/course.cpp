#include "tests/experiments/localisation/course.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "services/simulator/random.hpp"
#include "tests/experiments/localisation/field_box.hpp"
#include "tests/experiments/localisation/steering_law.hpp"

namespace markservo::experiments {
namespace {

using geometry::PlanePose;
using simulator::RandomBits;

constexpr std::uint64_t kPlanStream = 0xC1;
constexpr double kRunUp = 0.35;      // m at full speed before the field: reach of the antenna, and time to settle
constexpr double kStanding = 2.0;    // s
constexpr double kStaticTime = 6.5;  // s: 6 s from about the first read on
constexpr double kHallWay = 4.0;     // m

constexpr double kAlongGain = 3.0;  // 1/s

double uniform(RandomBits& bits, double from, double to) {
  return from + (to - from) * bits.uniform();
}

Eigen::Vector2d direction(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

PlanePose pose_at(const Eigen::Vector2d& p, double heading) {
  return {p.x(), p.y(), heading};
}

// From rest to full speed before `entry`, then on for `way`.
CoursePlan run_through(const Eigen::Vector2d& entry, double heading, double way, double speed) {
  const double run_up = 0.5 * speed * speed / kAcceleration + kRunUp;
  CoursePlan plan;
  plan.start = pose_at(entry - run_up * direction(heading), heading);
  plan.speeds = {{0.0, speed}};
  // Constant speed from the run-up's ramp on, which costs half its own time.
  plan.duration = (run_up + way) / speed + 0.5 * speed / kAcceleration;
  plan.scored_to = plan.duration;
  return plan;
}

// Where a line through `p` enters (first) and leaves the box, as ways along `heading`.
std::pair<double, double> crossing(const FieldBox& box, const Eigen::Vector2d& p, double heading) {
  const Eigen::Vector2d along = direction(heading);
  double enter = -1e9;
  double leave = 1e9;
  for (int axis = 0; axis < 2; ++axis) {
    const double a = (box.least[axis] - p[axis]) / along[axis];
    const double b = (box.greatest[axis] - p[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

// 4 m over the hall, in at one side at full speed.
CoursePlan across_the_hall(const FieldBox& box, double speed, RandomBits& bits) {
  const Eigen::Vector2d middle = box.middle();
  while (true) {
    const double heading = uniform(bits, -M_PI, M_PI);
    const Eigen::Vector2d p = middle + uniform(bits, -1.0, 1.0) * direction(heading + M_PI / 2.0);
    const auto [enter, leave] = crossing(box, p, heading);
    // A spacing that does not divide 4 m leaves a field a little narrower.
    const double way = std::min(kHallWay, 0.99 * box.size().minCoeff());
    if (leave - enter < way) continue;
    return run_through(p + enter * direction(heading), heading, way, speed);
  }
}

CoursePlan stop_and_go(const FieldBox& box, RandomBits& bits) {
  CoursePlan plan;
  const double heading = uniform(bits, -M_PI, M_PI);
  const Eigen::Vector2d middle = box.middle();
  const Eigen::Vector2d aside = uniform(bits, -0.3, 0.3) * direction(heading + M_PI / 2.0);
  plan.start = pose_at(middle + aside - 1.6 * direction(heading), heading);
  plan.speeds = {{0.0, 0.4}, {2.0, 0.0}, {3.5, 0.5}, {5.5, 0.15}, {7.0, 0.5}, {8.5, 0.0}};
  plan.duration = plan.scored_to = 10.0;
  return plan;
}

// What steers: how far off the course and how fast along it.
class CourseControl {
 public:
  explicit CourseControl(const CoursePlan& plan) : plan_(plan) {}

  // The command for the base at `truth`, `time` s after the begin; called every kControlPeriod.
  Eigen::Vector2d command(const simulator::BaseTruth& truth, double time) {
    double wanted = 0.0;
    for (const SpeedChange& change : plan_.speeds) {
      if (change.time <= time) wanted = change.speed;
    }
    speed_ += std::clamp(wanted - speed_, -kAcceleration * kControlPeriod, kAcceleration * kControlPeriod);
    behind_ += (speed_ - truth.speed) * kControlPeriod;
    if (wanted == 0.0 && speed_ == 0.0) return {0.0, 0.0};

    const PlanePose& start = plan_.start;
    const Eigen::Vector2d p(truth.pose.x, truth.pose.y);
    const Eigen::Vector2d begin(start.x, start.y);
    double heading = start.heading;
    double left_of_course = 0.0;
    double curvature = 0.0;
    if (plan_.radius > 0.0) {
      const Eigen::Vector2d centre = begin + plan_.radius * direction(start.heading + M_PI / 2.0);
      const Eigen::Vector2d from_centre = p - centre;
      heading = std::atan2(from_centre.y(), from_centre.x()) + M_PI / 2.0;
      left_of_course = plan_.radius - from_centre.norm();
      curvature = 1.0 / plan_.radius;
    } else {
      left_of_course = (p - begin).dot(direction(start.heading + M_PI / 2.0));
    }
    const double heading_error = geometry::wrapped(truth.pose.heading - heading);
    return {speed_ + kAlongGain * behind_, turn_rate_along(speed_, curvature, left_of_course, heading_error)};
  }

 private:
  const CoursePlan& plan_;
  double speed_ = 0.0;   // m/s, wanted now
  double behind_ = 0.0;  // m
};

}  // namespace

CoursePlan plan_course(const LocalisationCase& the_case, const robot::TagField& field, std::uint64_t seed) {
  RandomBits bits(simulator::seed_for(seed, kPlanStream, 0));
  const FieldBox box = field_box(field);
  const double speed = the_case.speed;
  const double length = box.size().y();
  const double width = box.size().x();
  // Between the columns as well as over one: half a spacing of the paper's field to either side.
  const double aside = uniform(bits, -0.05, 0.05);
  switch (the_case.kind) {
    case CourseKind::kStraight:
      return run_through({box.least.x() + 0.5 * width + aside, box.least.y()}, M_PI / 2.0, length, speed);
    case CourseKind::kStraightStanding: {
      CoursePlan plan;
      plan.start = {box.least.x() + 0.5 * width + aside, box.least.y(), M_PI / 2.0};
      plan.speeds = {{0.0, 0.0}, {kStanding, speed}};
      plan.duration = plan.scored_to = kStanding + length / speed + 0.5 * speed / kAcceleration;
      plan.scored_from = kStanding;
      return plan;
    }
    case CourseKind::kDiagonal: {
      const double way = std::sqrt(2.0) * width;
      return run_through({box.least.x(), box.least.y() + 0.5 * (length - width) + aside}, M_PI / 4.0, way, speed);
    }
    case CourseKind::kStatic: {
      CoursePlan plan;
      plan.start.x = uniform(bits, box.least.x(), box.greatest.x());
      plan.start.y = uniform(bits, box.least.y(), box.greatest.y());
      plan.start.heading = uniform(bits, -M_PI, M_PI);
      plan.speeds = {{0.0, 0.0}};
      plan.duration = plan.scored_to = kStaticTime;
      return plan;
    }
    case CourseKind::kHall:
      return across_the_hall(box, speed, bits);
    case CourseKind::kCircle: {
      CoursePlan plan;
      plan.radius = 0.8;
      const double angle = uniform(bits, -M_PI, M_PI);
      const Eigen::Vector2d middle = box.middle();
      plan.start = pose_at(middle + Eigen::Vector2d(aside, aside) + plan.radius * direction(angle), angle + M_PI / 2.0);
      plan.speeds = {{0.0, speed}};
      plan.duration = plan.scored_to = 2.0 * M_PI * plan.radius / speed + 1.0;
      return plan;
    }
    case CourseKind::kStopAndGo:
      return stop_and_go(box, bits);
  }
  throw std::logic_error("plan_course: unknown course");
}

Drive drive(const robot::RobotDescription& robot, const simulator::BaseRigParameters& parameters,
            const CoursePlan& plan, std::uint64_t seed) {
  CourseControl control(plan);
  const Steering steer = [&](const simulator::BaseTruth& truth, double time) { return control.command(truth, time); };
  return record_drive(robot, parameters, plan.start, plan.duration, steer, seed);
}

}  // namespace markservo::experiments
