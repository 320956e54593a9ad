#include "services/camera-check/camera_check_node.hpp"

#include <algorithm>
#include <markservo/StereoFrame.hpp>
#include <stdexcept>

#include "common/bus/bus.hpp"
#include "common/frames/frame_side.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/camera-check/marks/mark_messages.hpp"

namespace markservo::camera_check {
namespace {

using Json = nlohmann::ordered_json;

// What cannot be read is no fault of the cameras.
PairReport pair_report(const StereoFrame& frame) {
  frames::JpegDecoder left;
  frames::JpegDecoder right;
  try {
    return report_of(frames::picture_of(frame, frame.left, "the left picture of a pair", left),
                     frames::picture_of(frame, frame.right, "the right picture of a pair", right),
                     frame.calibration.cx_left - frame.calibration.cx_right);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
}

Json json_of(const PictureReport& picture) {
  return {{"bright_level", picture.light.bright_level},
          {"middle_level", picture.light.middle_level},
          {"blown_share", picture.light.blown_share},
          {"blur_px", picture.blur_px ? Json(*picture.blur_px) : Json()}};
}

Json json_of(const PairGeometry& geometry) {
  const RowOffsets& rows = geometry.rows;
  const bool known = geometry.num_matches > 0;
  return {{"points", geometry.num_corners},
          {"matches", geometry.num_matches},
          {"behind_infinity_share", known ? Json(geometry.behind_share) : Json()},
          {"rows_off_px", known ? Json(rows.middle_px) : Json()},
          {"rows_off_left_px", rows.left_px ? Json(*rows.left_px) : Json()},
          {"rows_off_right_px", rows.right_px ? Json(*rows.right_px) : Json()}};
}

Json json_of(const MarkSighting& mark) {
  Json json = {{"name", mark.name},       {"pairs", mark.pairs}, {"left", mark.left}, {"right", mark.right},
               {"located", mark.located}, {"cue", nullptr},      {"p_C_m", nullptr}};
  if (mark.located > 0) {
    json["cue"] = told_cue(mark);
    json["p_C_m"] = {mark.p_C.x(), mark.p_C.y(), mark.p_C.z()};
  }
  return json;
}

}  // namespace

void CameraCheckNode::add_log(const std::string& path) {
  bus::BusParameters parameters;
  parameters.urls = {"file://" + path + "?speed=0", "memq://"};
  parameters.service_name = "camera-check";
  parameters.robot = robot_;
  parameters.heartbeat = false;
  bus::Bus bus(parameters);
  StereoFrame newest;
  int pairs = 0;
  bus.on_each(channels::kStereoFrame, [&](const StereoFrame& frame) {
    newest = frame;
    ++pairs;
  });
  bus.on_each(channels::kMarkDetection, [this](const MarkDetection& detection) { add_to(marks_, detection); });
  bus.on_each(channels::kTargetPose, [this](const TargetPose& pose) { add_to(marks_, pose); });
  bus.spin();
  pairs_ += pairs;
  if (pairs == 0) return;
  pair_ = pair_report(newest);
}

std::vector<Finding> CameraCheckNode::findings() const {
  if (!pair_) return {{false, "there is no pair of pictures", "start stereo-camera, and see what it says"}};
  std::vector<Finding> all = findings_of(*pair_);
  for (Finding& each : findings_of(marks_.all())) all.push_back(std::move(each));
  return all;
}

Json CameraCheckNode::report() const {
  Json listed = Json::array();
  bool ok = true;
  for (const Finding& each : findings()) {
    ok = ok && each.ok;
    listed.push_back({{"ok", each.ok}, {"what", each.what}, {"mend", each.mend.empty() ? Json() : Json(each.mend)}});
  }
  Json marks = Json::array();
  for (const MarkSighting& mark : marks_.all()) marks.push_back(json_of(mark));
  Json json = {{"ok", ok}, {"pairs", pairs_}};
  if (pair_) {
    json["left"] = json_of(pair_->left);
    json["right"] = json_of(pair_->right);
    json["geometry"] = json_of(pair_->geometry);
  }
  json["marks"] = marks;
  json["findings"] = listed;
  return json;
}

}  // namespace markservo::camera_check
