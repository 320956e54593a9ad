#include "tests/scenes/glossy_ball.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

namespace markservo::scenes {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPerSide = 4;  // points of a pixel at which coverage is asked, a side

// Of the picture's pixel (u, v) by the ball.
double coverage(const GlossyBall& ball, int u, int v) {
  int covered = 0;
  for (int j = 0; j < kPerSide; ++j) {
    const double dv = v - 0.5 + (j + 0.5) / kPerSide - ball.v;
    for (int i = 0; i < kPerSide; ++i) {
      const double du = u - 0.5 + (i + 0.5) / kPerSide - ball.u;
      covered += std::hypot(du, dv) <= ball.radius ? 1 : 0;
    }
  }
  return covered / double(kPerSide * kPerSide);
}

// The ball's outward normal where the pixel looks at it; at and beyond the outline sideways.
Eigen::Vector3d normal_at(const GlossyBall& ball, int u, int v) {
  Eigen::Vector3d normal((u - ball.u) / ball.radius, (v - ball.v) / ball.radius, 0.0);
  normal.z() = std::sqrt(std::max(0.0, 1.0 - normal.squaredNorm()));
  return normal.normalized();
}

// How far from its middle the highlight reflects half of its peak, rad: a cap that covers the share of the box.
double half_angle(const GlossyBall& ball, const Eigen::Vector3d& towards) {
  const double foreshortening = std::max(0.2, towards.z());
  return std::asin(std::sqrt(std::min(0.9, 4.0 * ball.highlight_share / (kPi * foreshortening))));
}

class Shading {
 public:
  explicit Shading(const GlossyBall& ball)
      : ball_(ball),
        towards_((ball.to_lamp + Eigen::Vector3d::UnitZ()).normalized()),
        half_angle_(half_angle(ball, towards_)) {}

  cv::Vec3d at(int u, int v) const {
    const Eigen::Vector3d normal = normal_at(ball_, u, v);
    const double shade = ball_.ambient + (1.0 - ball_.ambient) * std::max(0.0, normal.dot(ball_.to_lamp));
    const double gloss = kWhite * highlight(normal);
    cv::Vec3d colour;
    for (std::size_t c = 0; c < 3; ++c) {
      colour[static_cast<int>(c)] = ball_.lamp[c] * (shade * ball_.body[c] + gloss);
    }
    return colour;
  }

 private:
  static constexpr double kWhite = 255.0;

  double highlight(const Eigen::Vector3d& normal) const {
    if (half_angle_ <= 0.0) return 0.0;
    const double angle = std::acos(std::clamp(normal.dot(towards_), -1.0, 1.0));
    return ball_.highlight_peak * std::exp2(-std::pow(angle / half_angle_, 2.0 * ball_.highlight_sharpness));
  }

  const GlossyBall& ball_;
  Eigen::Vector3d towards_;  // the normal that reflects the lamp into the camera
  double half_angle_;
};

cv::Vec3d wall_at(const GlossyBall& ball, int u, int v) {
  const double light = 1.0 + ball.wall_slope.x() * (double(u) / ball.width - 0.5) +
                       ball.wall_slope.y() * (double(v) / ball.height - 0.5);
  return {light * ball.lamp[0] * ball.wall[0], light * ball.lamp[1] * ball.wall[1],
          light * ball.lamp[2] * ball.wall[2]};
}

}  // namespace

BallPicture draw_ball(const GlossyBall& ball, std::uint64_t seed) {
  cv::Mat3d light(ball.height, ball.width);
  BallPicture picture;
  picture.mask = cv::Mat::zeros(ball.height, ball.width, CV_8UC1);
  const Shading shading(ball);
  for (int v = 0; v < ball.height; ++v) {
    for (int u = 0; u < ball.width; ++u) {
      const double covered = coverage(ball, u, v);
      light(v, u) = (1.0 - covered) * wall_at(ball, u, v);
      if (covered > 0.0) light(v, u) += covered * shading.at(u, v);
      if (covered >= 0.5) picture.mask.at<std::uint8_t>(v, u) = 255;
    }
  }
  if (ball.blur_px > 0.0) cv::GaussianBlur(light, light, {}, ball.blur_px);
  cv::Mat3d noise(ball.height, ball.width);
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, ball.noise);
  cv::Mat(light + noise).convertTo(picture.image, CV_8UC3);
  picture.box = cv::boundingRect(picture.mask);
  return picture;
}

}  // namespace markservo::scenes
