#include "tests/experiments/drive_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/experiments/lift_truth.hpp"

namespace markservo::experiments {
namespace {

const cv::Scalar kPaper(250, 250, 250);
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kTag(200, 200, 200);
const cv::Scalar kTold(30, 120, 240);
const cv::Scalar kGoal(60, 160, 40);
constexpr double kPixelsPerMetre = 560.0;
constexpr double kMargin = 0.05;      // m
constexpr int kLegendHeight = 30;     // px
constexpr int kLabelWidth = 95;       // px, on the right
constexpr double kTagRadius = 0.008;  // m
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kTextScale = 0.45;
constexpr double kBar = 0.1;  // m, of the scale

Eigen::Isometry2d isometry(const Pose2& pose) {
  return Eigen::Translation2d(pose.x, pose.y) * Eigen::Rotation2Dd(pose.heading);
}

// The outline of the robot at `pose`, in W; a robot that does not drive has none.
std::vector<Eigen::Vector2d> outline(const robot::RobotDescription& robot, const Pose2& pose) {
  if (!robot.base) return {};
  const auto& base = *robot.base;
  const Eigen::Isometry2d X_WR = isometry(pose);
  return {X_WR * Eigen::Vector2d(base.front, base.half_width), X_WR * Eigen::Vector2d(base.front, -base.half_width),
          X_WR * Eigen::Vector2d(-base.rear, -base.half_width), X_WR * Eigen::Vector2d(-base.rear, base.half_width)};
}

std::vector<Eigen::Vector2d> points(const std::vector<Pose2>& poses) {
  std::vector<Eigen::Vector2d> result;
  for (const Pose2& pose : poses) result.emplace_back(pose.x, pose.y);
  return result;
}

// A plan whose longer side lies across the picture, so that a long way needs no high one.
class Plan {
 public:
  explicit Plan(const std::vector<Eigen::Vector2d>& shown) {
    for (const Eigen::Vector2d& point : shown) box_.extend(point);
    box_.extend(Eigen::Vector2d(box_.min().array() - kMargin));
    box_.extend(Eigen::Vector2d(box_.max().array() + kMargin));
    turned_ = box_.sizes().y() > box_.sizes().x();
    const Eigen::Vector2d size = turned_ ? Eigen::Vector2d(box_.sizes().y(), box_.sizes().x()) : box_.sizes();
    image = cv::Mat(kLegendHeight + pixels(size.y()), std::max(pixels(size.x()) + kLabelWidth, 640), CV_8UC3, kPaper);
  }

  cv::Point at(const Eigen::Vector2d& p_W) const {
    const double right = turned_ ? p_W.y() - box_.min().y() : p_W.x() - box_.min().x();
    const double down = turned_ ? p_W.x() - box_.min().x() : box_.max().y() - p_W.y();
    return {pixels(right), kLegendHeight + pixels(down)};
  }

  void line(const std::vector<Eigen::Vector2d>& way, const cv::Scalar& colour, int thickness, bool closed = false) {
    std::vector<cv::Point> corners;
    for (const Eigen::Vector2d& point : way) corners.push_back(at(point));
    if (!corners.empty()) cv::polylines(image, corners, closed, colour, thickness, cv::LINE_AA);
  }

  void text(const std::string& words, cv::Point place, const cv::Scalar& colour = kInk) {
    cv::putText(image, words, place, kFont, kTextScale, colour, 1, cv::LINE_AA);
  }

  // A bar of kBar from `left` on, with its length behind.
  void scale(cv::Point left) {
    constexpr int kEnds = 4;  // px, either way
    const cv::Point right = left + cv::Point(pixels(kBar), 0);
    cv::line(image, left, right, kInk);
    for (const cv::Point& end : {left, right})
      cv::line(image, end - cv::Point(0, kEnds), end + cv::Point(0, kEnds), kInk);
    text("0.1 m", right + cv::Point(6, 4));
  }

  static int pixels(double metres) { return static_cast<int>(std::lround(metres * kPixelsPerMetre)); }

  cv::Mat image;

 private:
  Eigen::AlignedBox2d box_;
  bool turned_ = false;
};

struct PlacedMark {
  std::string name;
  Eigen::Vector2d p_W;
};

std::vector<PlacedMark> placed_marks(const robot::RobotDescription& robot, const SimTruth& truth, const Pose2& pose) {
  std::vector<PlacedMark> marks;
  for (const auto& mark : truth.marks) {
    const auto* description = robot.find_mark(mark.name);
    if (description == nullptr || description->role != robot::MarkRole::kTarget) continue;
    const Eigen::Vector2d p_R = robot.cameras.p_RC.head<2>() + Eigen::Vector2d(mark.p_C.y, -mark.p_C.x);
    marks.push_back({mark.name, isometry(pose) * p_R});
  }
  return marks;
}

}  // namespace

void write_drive_picture(const std::string& path, const robot::RobotDescription& robot, const DriveWatch& drive,
                         const Pose2& goal, const SimTruth& truth) {
  if (drive.true_way().empty()) return;
  const Pose2& begin = drive.true_way().front();
  const Pose2& end = drive.true_way().back();
  std::vector<Eigen::Vector2d> tags;
  if (robot.floor_tags) {
    for (const auto& tag : robot.floor_tags->field("").tags) tags.push_back(tag.p_W);
  }
  const auto marks = placed_marks(robot, truth, end);
  std::vector<Eigen::Vector2d> shown = tags;
  for (const auto& more : {points(drive.true_way()), outline(robot, begin), outline(robot, end)}) {
    shown.insert(shown.end(), more.begin(), more.end());
  }
  for (const PlacedMark& mark : marks) shown.push_back(mark.p_W);

  Plan plan(shown);
  for (const Eigen::Vector2d& tag : tags) {
    cv::circle(plan.image, plan.at(tag), Plan::pixels(kTagRadius), kTag, cv::FILLED, cv::LINE_AA);
  }
  plan.line(outline(robot, begin), kTag, 2, true);
  plan.line(outline(robot, end), kInk, 2, true);
  plan.line(points(drive.true_way()), kInk, 2);
  plan.line(points(drive.told_way()), kTold, 1);
  cv::drawMarker(plan.image, plan.at({goal.x, goal.y}), kGoal, cv::MARKER_TILTED_CROSS, 18, 2, cv::LINE_AA);
  for (const PlacedMark& mark : marks) {
    cv::circle(plan.image, plan.at(mark.p_W), 5, kInk, cv::FILLED, cv::LINE_AA);
    plan.text(mark.name, plan.at(mark.p_W) + cv::Point(12, 5));
  }
  plan.text("true way", {8, 20});
  plan.text("as ROBOT_POSE told it", {90, 20}, kTold);
  plan.text("goal", {280, 20}, kGoal);
  plan.text("dots: tags in the floor", {340, 20}, cv::Scalar(140, 140, 140));
  plan.scale({525, 16});
  cv::imwrite(path, plan.image);
}

}  // namespace markservo::experiments
