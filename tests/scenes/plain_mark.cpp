#include "tests/scenes/plain_mark.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "tests/scenes/area_coverage.hpp"

namespace markservo::scenes {
namespace {

constexpr int kPointsAround = 720;  // of a round contour: a thousandth of a pixel from the true one
constexpr int kMargin_px = 12;      // about the contour: what the blur reaches and what tells the colours

// A regular polygon with a side below, its middle at the mark's centre.
std::vector<cv::Point2d> polygon_contour(const PlainMark& mark, int corners, const Eye& eye) {
  const double radius = 0.5 * mark.size / std::sin(M_PI / corners);
  std::vector<cv::Point2d> contour;
  for (int k = 0; k < corners; ++k) {
    const double angle = (2.0 * k + 1.0) * M_PI / corners - 0.5 * M_PI;
    const Eigen::Vector3d corner(radius * std::cos(angle), 0.0, radius * std::sin(angle));
    contour.push_back(eye.image_of(mark.p_C + mark.axes * corner));
  }
  return contour;
}

// A circle in space.
std::vector<cv::Point2d> circle_contour(const Eigen::Vector3d& centre, const Eigen::Vector3d& along,
                                        const Eigen::Vector3d& across, const Eye& eye) {
  std::vector<cv::Point2d> contour;
  for (int k = 0; k < kPointsAround; ++k) {
    const double angle = 2.0 * M_PI * k / kPointsAround;
    contour.push_back(eye.image_of(centre + std::cos(angle) * along + std::sin(angle) * across));
  }
  return contour;
}

// Where lines of sight touch the ball.
std::vector<cv::Point2d> ball_contour(const PlainMark& mark, const Eye& eye) {
  const Eigen::Vector3d off = mark.p_C - eye.origin;
  const double radius = 0.5 * mark.size;
  const double ratio_2 = radius * radius / off.squaredNorm();
  const Eigen::Vector3d along = off.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d across = along.cross(off).normalized();
  const double seen = radius * std::sqrt(1.0 - ratio_2);
  return circle_contour(eye.origin + (1.0 - ratio_2) * off, seen * along, seen * across, eye);
}

cv::Rect box_about(const std::vector<cv::Point2d>& contour) {
  cv::Point2d least(1e9, 1e9);
  cv::Point2d most(-1e9, -1e9);
  for (const cv::Point2d& p : contour) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  const cv::Point corner(static_cast<int>(std::floor(least.x)) - kMargin_px,
                         static_cast<int>(std::floor(least.y)) - kMargin_px);
  const cv::Point end(static_cast<int>(std::ceil(most.x)) + kMargin_px + 1,
                      static_cast<int>(std::ceil(most.y)) + kMargin_px + 1);
  return {corner, end};
}

// The mark moved, turned about its own axes, and grown.
constexpr int kGeometry = 7;
PlainMark changed(const PlainMark& mark, int parameter, double by) {
  PlainMark moved = mark;
  if (parameter < 3) moved.p_C[parameter] += by;
  if (parameter >= 3 && parameter < 6) {
    moved.axes = mark.axes * Eigen::AngleAxisd(by, Eigen::Vector3d::Unit(parameter - 3)).toRotationMatrix();
  }
  if (parameter == 6) moved.size += by;
  return moved;
}

// Of the seven, those that change what is seen.
std::vector<int> shown_by(PlainForm form) {
  if (form == PlainForm::kBall) return {0, 1, 2, 6};
  if (form == PlainForm::kDisc) return {0, 1, 2, 3, 5, 6};
  return {0, 1, 2, 3, 4, 5, 6};
}

// Adds one view's information about (geometry, blur, colour, around).
void add_information(const PlainMark& mark, const Eye& eye, const std::vector<int>& geometry, double sigma,
                     Eigen::MatrixXd& information) {
  const cv::Rect box = box_about(contour_of(mark, eye));
  const cv::Mat1f share = blurred_coverage(contour_of(mark, eye), box, mark.blur_px);
  const double distance = mark.p_C.norm();
  const auto n = static_cast<int>(geometry.size());
  std::vector<cv::Mat1f> derivatives;
  for (const int parameter : geometry) {
    // A hundredth of a pixel or so.
    const double step = parameter < 3 || parameter == 6 ? 1e-5 * distance : 1e-5 * distance / mark.size;
    const PlainMark moved = changed(mark, parameter, step);
    derivatives.emplace_back((blurred_coverage(contour_of(moved, eye), box, mark.blur_px) - share) / step);
  }
  constexpr double kBlurStep = 0.005;  // px
  derivatives.emplace_back((blurred_coverage(contour_of(mark, eye), box, mark.blur_px + kBlurStep) - share) /
                           kBlurStep);
  Eigen::VectorXd row(n + 7);
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        row.setZero();
        const double contrast = mark.colour[channel] - mark.around[channel];
        for (int k = 0; k <= n; ++k)
          row[k] = contrast * static_cast<double>(derivatives[static_cast<std::size_t>(k)](y, x));
        row[n + 1 + channel] = static_cast<double>(share(y, x));
        row[n + 4 + channel] = 1.0 - static_cast<double>(share(y, x));
        information.selfadjointView<Eigen::Lower>().rankUpdate(row, 1.0 / (sigma * sigma));
      }
    }
  }
}

}  // namespace

double lens_blur(double total_px) {
  constexpr double kOfPixel_2 = 1.0 / 12.0;  // px^2, variance of its square
  return std::sqrt(total_px * total_px - kOfPixel_2);
}

std::vector<cv::Point2d> contour_of(const PlainMark& mark, const Eye& eye) {
  switch (mark.form) {
    case PlainForm::kSquare:
      return polygon_contour(mark, 4, eye);
    case PlainForm::kTriangle:
      return polygon_contour(mark, 3, eye);
    case PlainForm::kDisc:
      return circle_contour(mark.p_C, 0.5 * mark.size * mark.axes.col(0), 0.5 * mark.size * mark.axes.col(2), eye);
    case PlainForm::kBall:
      break;
  }
  return ball_contour(mark, eye);
}

cv::Mat3f picture_of(const PlainMark& mark, const Eye& eye, const cv::Size& size) {
  cv::Mat3f picture(size, cv::Vec3f(mark.around));
  const std::vector<cv::Point2d> contour = contour_of(mark, eye);
  const cv::Rect box = box_about(contour) & cv::Rect({0, 0}, size);
  if (box.empty()) return picture;
  const cv::Mat1f share = blurred_coverage(contour, box, mark.blur_px);
  const cv::Vec3d step = mark.colour - mark.around;
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      picture(box.y + y, box.x + x) = cv::Vec3f(mark.around + static_cast<double>(share(y, x)) * step);
    }
  }
  return picture;
}

Eigen::Matrix3d least_covariance(const PlainMark& mark, const geometry::StereoCamera& camera, double sigma) {
  const std::vector<int> geometry = shown_by(mark.form);
  const auto n = static_cast<Eigen::Index>(geometry.size()) + 7;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
  for (const bool right : {false, true}) add_information(mark, Eye(camera, right), geometry, sigma, information);
  const Eigen::MatrixXd full = information.selfadjointView<Eigen::Lower>();
  // Unknowns of very different units: solved with all of them of unit information.
  const Eigen::VectorXd unit = full.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = unit.asDiagonal() * full * unit.asDiagonal();
  const Eigen::MatrixXd inverse = scaled.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::Vector3d of_centre = unit.head<3>();
  return of_centre.asDiagonal() * inverse.topLeftCorner<3, 3>() * of_centre.asDiagonal();
}

double least_disparity_sigma(const PlainMark& mark, const geometry::StereoCamera& camera, double sigma) {
  const Eigen::Matrix3d covariance = least_covariance(mark, camera, sigma);
  return std::sqrt(covariance(1, 1)) * camera.fx * camera.baseline / (mark.p_C.y() * mark.p_C.y());
}

}  // namespace markservo::scenes
