#pragma once

// The chain that one would put together from OpenCV's parts to find and measure marks: what ours is compared with.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::bench {

// Per image: equalised luma (by way of YCrCb and back), HSV; per mark inRange (two where the hue wraps), opening by
// 3 x 3, outer contours, box and moments of the largest. Per mark: Sobel gradients, structure tensor, Foerstner's W and
// C, the 32 best maxima in the left box; SAD of 7 x 7 on both gradients over +-w/4 columns and +-2 rows about the
// boxes' disparity, a parabola, triangulation. Buffers are kept from call to call.
class BaselineAt {
 public:
  struct Match {
    double u_left = 0.0;   // px
    double v = 0.0;        // px
    double u_right = 0.0;  // px
    Eigen::Vector3d p_C = Eigen::Vector3d::Zero();
  };
  struct View {
    cv::Mat mask;  // of the mark's colour, cleaned
    std::vector<std::vector<cv::Point>> contours;
    std::size_t largest = 0;  // of the contours
    cv::Rect box;             // empty: not found
    cv::Moments moments;
  };
  struct Mark {
    View left;
    View right;
    std::vector<Match> matches;
  };

  BaselineAt(const std::vector<robot::MarkDescription>& marks, const geometry::StereoCamera& camera);

  // The marks of a pair of 8-bit BGR images, in the order given above; valid until the next call.
  const std::vector<Mark>& run(const cv::Mat& left, const cv::Mat& right);

 private:
  // inRange's bounds in OpenCV's 8-bit HSV, where hue is half the degrees; a hue that wraps has two.
  struct Bounds {
    cv::Scalar low;
    cv::Scalar high;
  };
  struct Gradients {
    cv::Rect area;
    cv::Mat grey;
    cv::Mat dx;  // 16-bit
    cv::Mat dy;
  };
  struct Feature {
    int u = 0;  // px of the left gradients' area
    int v = 0;
    float weight = 0.0F;
  };

  void find_marks(const cv::Mat& image, View Mark::*side);
  void find_view(const std::vector<Bounds>& bounds, View& view);
  static void take_gradients(const cv::Mat& image, const cv::Rect& area, Gradients& gradients);
  void find_features();
  void match(Mark& mark, int disparity, int reach);

  geometry::StereoCamera camera_;
  std::vector<std::vector<Bounds>> bounds_;
  std::vector<Mark> marks_;
  cv::Mat kernel_;
  cv::Mat ycrcb_;
  std::array<cv::Mat, 3> planes_;
  cv::Mat equalised_;
  cv::Mat hsv_;
  cv::Mat wrapped_;
  Gradients left_;
  Gradients right_;
  cv::Mat xx_;
  cv::Mat xy_;
  cv::Mat yy_;
  cv::Mat weight_;
  cv::Mat greatest_;
  std::vector<Feature> features_;
  std::vector<int> best_row_;  // costs by column
  std::vector<int> row_costs_;
};

}  // namespace markservo::bench
