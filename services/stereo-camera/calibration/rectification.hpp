#pragma once

// How two cameras are turned, in thought, until rows of their pictures are epipolar lines; and whether that is what a
// calibration does.

#include <opencv2/core.hpp>

#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

// `calibration` with R and P of both cameras for pictures of `size`: as they are where it is rectified, else by
// Bouguet's method from K, D, R and T (cv::stereoRectify, principal points of one column). The view is the largest
// without a black border (alpha 0); where a lens's model folds within the picture, so that this is not defined, the
// view of the mean pinhole camera.
StereoCalibration with_rectification(const StereoCalibration& calibration, cv::Size size);

// How far rows of the two rectified pictures of `size` are apart for one point, px, at most, from infinity to where the
// pictures' width is the disparity's eightfold; 0 where R and T are not stated. The calibration is rectified.
double row_error_px(const StereoCalibration& calibration, cv::Size size);

}  // namespace markservo::stereo_camera
