#include "tests/unit/base-navigator/drive_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markservo::base_navigator::test {
namespace {

using geometry::PlanePose;

double distance_to_wall(const Outline& outline, const PlanePose& X_RW, const Wall& wall) {
  // Fine enough: outline against points every 5 mm of the wall.
  const Eigen::Vector2d a = X_RW * wall.a;
  const Eigen::Vector2d b = X_RW * wall.b;
  // Only what is near matters.
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  const Eigen::Vector2d unit = length > 0.0 ? Eigen::Vector2d(along / length) : Eigen::Vector2d::Zero();
  const double foot = std::clamp(-a.dot(unit), 0.0, length);
  double least = std::min(distance_to_outline(outline, a), distance_to_outline(outline, b));
  for (double s = std::max(0.0, foot - 0.5); s <= std::min(length, foot + 0.5); s += 0.005) {
    least = std::min(least, distance_to_outline(outline, a + s * unit));
  }
  return least;
}

}  // namespace

std::vector<Wall> box(double x_min, double y_min, double x_max, double y_max) {
  return {{{x_min, y_min}, {x_max, y_min}},
          {{x_max, y_min}, {x_max, y_max}},
          {{x_max, y_max}, {x_min, y_max}},
          {{x_min, y_max}, {x_min, y_min}}};
}

DriveWorld::DriveWorld(const robot::RobotDescription& robot, const WorldSettings& settings, std::uint64_t seed)
    : robot_(robot), settings_(settings), random_(seed) {
  for (int i = 0; i < settings.command_delay; ++i) commands_.push_back(Command());
}

void DriveWorld::step(const Command& command) {
  commands_.push_back(command);
  const Command obeyed = commands_.front();
  commands_.pop_front();
  const double dt = 1e-6 * static_cast<double>(kStep_us);
  const robot::BaseDescription& base = *robot_.base;
  const double most = settings_.base_braking * base.acceleration_max * dt;
  const double most_turn = settings_.base_braking * base.turn_acceleration_max * dt;
  speed += std::clamp(obeyed.speed - speed, -most, most);
  turn_rate += std::clamp(obeyed.turn_rate - turn_rate, -most_turn, most_turn);
  left_ += (speed - 0.5 * base.track * turn_rate) * dt;
  right_ += (speed + 0.5 * base.track * turn_rate) * dt;
  const double way = settings_.odometry_scale * speed * dt;
  X_WR = X_WR * PlanePose{0.0, 0.0, 0.5 * turn_rate * dt} * PlanePose{way, 0.0, 0.5 * turn_rate * dt};
  stood_ = std::abs(speed) < 0.005 && std::abs(turn_rate) < 0.01 ? stood_ + dt : 0.0;
  utime += kStep_us;
  ++steps_;
}

OdometrySample DriveWorld::odometry() const {
  const double tick = robot_.base->metres_per_tick();
  return {utime, std::floor(left_ / tick) * tick, std::floor(right_ / tick) * tick};
}

// The share of the pose's error that is left after standing.
double DriveWorld::shrunk() const {
  return std::max(0.4, 1.0 - 0.12 * stood_);
}

PoseSample DriveWorld::pose() {
  if (steps_ % kStepsPerRead == 0) {
    // Reads come in: the error is drawn anew in part, and shrinks while the robot stands.
    std::normal_distribution<double> normal;
    const double size = shrunk();
    const double keep = 0.7;
    const double fresh = size * std::sqrt(1.0 - keep * keep);
    pose_error_.x = keep * pose_error_.x + fresh * settings_.position_noise * normal(random_);
    pose_error_.y = keep * pose_error_.y + fresh * settings_.position_noise * normal(random_);
    pose_error_.heading = keep * pose_error_.heading + fresh * settings_.heading_noise * normal(random_);
  }
  PoseSample sample;
  sample.utime = utime;
  sample.state = localisation;
  sample.X_WR = X_WR * pose_error_;
  sample.position_sigma = shrunk() * position_sigma;
  sample.heading_sigma = heading_sigma;
  return sample;
}

double DriveWorld::ray(const PlanePose& X_WS, double angle) const {
  const Eigen::Vector2d from = X_WS.position();
  const Eigen::Vector2d d(std::cos(X_WS.heading + angle), std::sin(X_WS.heading + angle));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d e = wall.b - wall.a;
    const double det = d.y() * e.x() - d.x() * e.y();
    if (std::abs(det) < 1e-12) continue;
    const Eigen::Vector2d f = wall.a - from;
    const double range = (f.y() * e.x() - f.x() * e.y()) / det;
    const double part = (d.x() * f.y() - d.y() * f.x()) / det;
    if (range >= 0.0 && part >= 0.0 && part <= 1.0) nearest = std::min(nearest, range);
  }
  return nearest;
}

SonarScanSample DriveWorld::scan() {
  constexpr int kRays = 31;
  const robot::SonarRingDescription& ring = *robot_.sonars;
  std::normal_distribution<double> noise(0.0, settings_.sonar_noise);
  std::uniform_real_distribution<double> chance;
  SonarScanSample scan;
  scan.utime = utime;
  scan.min_range = ring.min_range;
  scan.max_range = ring.max_range;
  scan.beam_width = ring.beam_width;
  for (int i = 0; i < ring.number; ++i) {
    SonarReading reading;
    reading.X_RS = ring.pose(i);
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kRays; ++k) {
      nearest = std::min(nearest, ray(X_WR * reading.X_RS, ring.beam_width * (k / (kRays - 1.0) - 0.5)));
    }
    const double range = std::max(nearest + noise(random_), ring.min_range);
    reading.heard = range <= ring.max_range && chance(random_) >= settings_.lost_echoes;
    reading.range = reading.heard ? range : ring.max_range;
    scan.readings.push_back(reading);
  }
  return scan;
}

double DriveWorld::nearest() const {
  const robot::BaseDescription& base = *robot_.base;
  const Outline outline{base.front, base.rear, base.half_width};
  double least = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) least = std::min(least, distance_to_wall(outline, X_WR.inverse(), wall));
  return least;
}

}  // namespace markservo::base_navigator::test
