#include "tests/experiments/localisation/localizer_run.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "tests/experiments/child_process.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/localisation/run_log.hpp"

namespace markservo::experiments {
namespace {

std::vector<std::string> words(const Told& told) {
  std::vector<std::string> result;
  const auto add = [&result](const std::string& option, double value) {
    result.push_back(option);
    result.push_back(std::to_string(value));
  };
  if (told.start_heading) {
    add("--start-heading", geometry::degrees(geometry::wrapped(*told.start_heading)));
    add("--start-heading-sigma", geometry::degrees(told.start_heading_sigma));
  }
  if (told.delay_sigma) add("--delay-sigma", *told.delay_sigma);
  return result;
}

PoseEstimate estimate(const RobotPose& message) {
  PoseEstimate result;
  result.time = seconds(message.utime);
  result.p_WR = {message.pose.x, message.pose.y};
  result.heading = message.pose.heading;
  const auto& P = message.covariance;
  result.covariance << P.xx, P.xy, P.xh, P.xy, P.yy, P.yh, P.xh, P.yh, P.hh;
  result.speed = message.speed;
  result.turn_rate = message.turn_rate;
  result.localised = message.state == RobotPose::LOCALISED;
  return result;
}

}  // namespace

Localised localise(const Drive& drive, const LocalizerRun& run) {
  const std::string in = run.files + ".lcm";
  const std::string out = run.files + "-poses.lcm";
  const std::string log = run.files + ".log";
  std::filesystem::remove(out);
  write_log(drive, run.with_odometry, in);
  std::vector<std::string> command{sibling_executable("rfid-localizer"),
                                   "--robot-file",
                                   run.robot_file,
                                   "--tag-field",
                                   run.tag_field,
                                   "--lcm-in",
                                   "file://" + in + "?speed=0",
                                   "--lcm-out",
                                   "file://" + out + "?mode=w"};
  const auto more = words(run.told);
  command.insert(command.end(), more.begin(), more.end());
  const int code = ChildProcess(command, log).wait();
  if (code != 0) {
    throw std::runtime_error("rfid-localizer ended with exit code " + std::to_string(code) + ", see " + log);
  }
  Localised result;
  result.messages = read_poses(out);
  if (result.messages.empty()) throw std::runtime_error(out + ": holds no ROBOT_POSE");
  for (const auto& message : result.messages) result.estimates.push_back(estimate(message));
  if (!run.keep_files) {
    for (const auto& file : {in, out, log}) std::filesystem::remove(file);
  }
  return result;
}

std::vector<PaperRead> paper_reads(const Localised& localised, const Eigen::Vector2d& p_RF) {
  std::vector<PaperRead> reads;
  std::int64_t last = 0;
  for (const RobotPose& message : localised.messages) {
    const PaperLocalisation& paper = message.paper;
    if (paper.measured_known == 0 || paper.utime == last) continue;
    last = paper.utime;
    const double time = seconds(paper.utime);
    const PoseEstimate* fused = newest(localised.estimates, time);
    if (fused == nullptr) continue;
    const PoseEstimate at_read = moved_on(*fused, time);
    PathPoint robot;
    robot.p_WR = at_read.p_WR;
    robot.heading = at_read.heading;
    reads.push_back(
        {time, {paper.measured_x, paper.measured_y}, {paper.compensated_x, paper.compensated_y}, robot.at(p_RF)});
  }
  return reads;
}

}  // namespace markservo::experiments
