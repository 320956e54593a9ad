// Writes the seeds of messages_fuzz: one valid message of each type, the larger ones filled.
// usage: make_message_seeds FOLDER     (run it again when a message type changes; FOLDER is corpus/messages_fuzz)

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tests/fuzz/channel_types.hpp"

namespace markservo::fuzz {
namespace {

// With what every message says of itself.
template <class M>
M numbered() {
  M message{};
  if constexpr (messages::has_seq<M>::value) {
    message.session = 1;
    message.seq = 1;
  }
  return message;
}

// And with what its rules ask for.
template <class M>
M valid_message() {
  return numbered<M>();
}

StereoCalibration calibration() {
  return {784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
}

template <>
StereoFrame valid_message<StereoFrame>() {
  auto frame = numbered<StereoFrame>();
  frame.calibration = calibration();
  frame.width = 8;
  frame.height = 8;
  frame.encoding = StereoFrame::ENCODING_JPEG;
  const cv::Mat image(frame.height, frame.width, CV_8UC3, cv::Scalar(40, 35, 190));
  cv::imencode(".jpg", image, frame.left);
  frame.right = frame.left;
  frame.left_size = static_cast<std::int32_t>(frame.left.size());
  frame.right_size = static_cast<std::int32_t>(frame.right.size());
  return frame;
}

template <>
LearnRequest valid_message<LearnRequest>() {
  LearnRequest request{};
  request.session = 1;
  request.request_id = 1;
  request.mark = "red";
  request.width = 8;
  request.height = 8;
  request.frame = valid_message<StereoFrame>();
  request.piece = request.frame.left;
  request.left_size = request.piece_size = request.frame.left_size;
  request.frame.left.clear();
  request.frame.right.clear();
  request.frame.left_size = request.frame.right_size = 0;
  return request;
}

template <>
LearnResult valid_message<LearnResult>() {
  auto result = numbered<LearnResult>();
  result.mark = "red";
  result.learned = 1;
  result.hue_min_deg = 345.0;
  result.hue_max_deg = 15.0;
  result.saturation_max = 1.0;
  result.value_max = 1.0;
  result.covered = 1.0;
  result.mask_width = 8;
  result.mask_height = 8;
  result.mask.resize(8, 0xff);
  result.mask_size = static_cast<std::int32_t>(result.mask.size());
  result.warnings.resize(1);
  result.num_warnings = 1;
  return result;
}

MarkView view() {
  MarkView view{};
  view.seen = 1;
  view.width = 8;
  view.height = 8;
  view.patch.scale = 1;
  view.patch.width = 8;
  view.patch.height = 8;
  view.patch.bgr.resize(8 * 8 * 3, 100);
  view.patch.bgr_size = static_cast<std::int32_t>(view.patch.bgr.size());
  view.patch.mask.resize(8, 0xff);
  view.patch.mask_size = static_cast<std::int32_t>(view.patch.mask.size());
  return view;
}

template <>
MarkDetection valid_message<MarkDetection>() {
  auto detection = numbered<MarkDetection>();
  detection.calibration = calibration();
  detection.width = 8;
  detection.height = 8;
  DetectedMark mark{};
  mark.name = "red";
  mark.left = view();
  mark.right = view();
  detection.marks = {mark};
  detection.num_marks = 1;
  return detection;
}

template <>
TargetPose valid_message<TargetPose>() {
  auto pose = numbered<TargetPose>();
  LocatedMark mark{};
  mark.name = "red";
  pose.marks = {mark};
  pose.num_marks = 1;
  return pose;
}

template <>
StereoMatches valid_message<StereoMatches>() {
  auto matches = numbered<StereoMatches>();
  MarkMatches mark{};
  mark.name = "red";
  mark.num_matches = 1;
  for (auto* values : {&mark.u_left, &mark.v_left, &mark.u_right, &mark.v_right, &mark.residual})
    values->assign(1, 0.0);
  matches.marks = {mark};
  matches.num_marks = 1;
  return matches;
}

template <>
JointState valid_message<JointState>() {
  auto state = numbered<JointState>();
  state.num_joints = 3;
  state.position.assign(3, 0.0);
  state.speed.assign(3, 0.0);
  return state;
}

template <>
TaskCommand valid_message<TaskCommand>() {
  auto command = numbered<TaskCommand>();
  command.session = 1;
  command.target = "red";
  command.drive = 1;
  command.drive_pose = {0.2, 1.05, 1.5};
  return command;
}

template <>
StopRequest valid_message<StopRequest>() {
  auto request = numbered<StopRequest>();
  request.session = 1;
  return request;
}

template <>
RfidTagHits valid_message<RfidTagHits>() {
  auto hits = numbered<RfidTagHits>();
  hits.utime = 200'000;
  hits.window_start = 100'000;
  hits.window_end = 200'000;
  RfidTagHit hit{};
  hit.uid = "E004015000001000";
  hit.utime = 150'000;
  hits.hits = {hit};
  hits.num_hits = 1;
  return hits;
}

template <>
SonarScan valid_message<SonarScan>() {
  auto scan = numbered<SonarScan>();
  scan.min_range = 0.1;
  scan.max_range = 5.0;
  scan.beam_width = 0.5;
  SonarEcho echo{};
  echo.pose = {0.22, 0.0, 0.0};
  echo.heard = 1;
  echo.range = 1.0;
  scan.echoes = {echo};
  scan.num_echoes = 1;
  return scan;
}

template <>
RobotPose valid_message<RobotPose>() {
  auto pose = numbered<RobotPose>();
  pose.odometry_session = 1;
  pose.odometry_seq = 1;
  pose.state = RobotPose::LOCALISED;
  pose.pose = {0.2, 1.05, 1.5};
  pose.covariance = {1e-4, 0.0, 0.0, 1e-4, 0.0, 1e-3};
  pose.speed = 0.4;
  pose.odometry_used = 1;
  pose.delay = 0.19;
  pose.delay_sigma = 0.01;
  pose.paper.measured_known = 1;
  pose.paper.measured_x = 0.2;
  pose.paper.measured_y = 1.0;
  pose.paper.compensated_x = 0.2;
  pose.paper.compensated_y = 1.08;
  return pose;
}

template <>
BaseGoal valid_message<BaseGoal>() {
  auto goal = numbered<BaseGoal>();
  goal.kind = BaseGoal::DRIVE;
  goal.pose = {0.2, 1.05, 1.5};
  goal.clearance = 0.05;
  goal.speed = 0.4;
  return goal;
}

template <class M>
void write(const std::string& folder, std::uint8_t index) {
  const M message = valid_message<M>();
  if (const std::string why = messages::broken_rule(message); !why.empty()) {
    std::fprintf(stderr, "the seed of %s is not valid: %s\n", M::getTypeName(), why.c_str());
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  bytes.insert(bytes.begin(), index);
  std::ofstream(folder + "/" + M::getTypeName(), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

template <class... Types>
void write_all(const std::string& folder, Channels<Types...>) {
  std::uint8_t index = 0;
  (write<Types>(folder, index++), ...);
}

}  // namespace
}  // namespace markservo::fuzz

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_message_seeds FOLDER\n");
    return 2;
  }
  markservo::fuzz::write_all(argv[1], markservo::fuzz::ChannelTypes{});
  return 0;
}
