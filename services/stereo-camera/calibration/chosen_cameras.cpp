#include "services/stereo-camera/calibration/chosen_cameras.hpp"

#include <fmt/core.h>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/rectification.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {
namespace {

void require_size(const CameraGeometry& geometry, cv::Size size) {
  if (!geometry.size || size == *geometry.size) return;
  throw ConfigurationError(fmt::format("pictures are {}; allowed: {} as in {}{}", size_text(size),
                                       size_text(*geometry.size), geometry.size_source,
                                       geometry.calibration ? "" : " (or --calibration, or --fx and --baseline)"));
}

// Where a camera matrix has its principal point outside the middle half of such pictures, that it does: a calibration
// for another size of pictures shows by it, and nothing of what comes out would tell.
std::string far_principal_point(const StereoCalibration& calibration, cv::Size size) {
  const auto near_middle = [](double share) { return share > 0.25 && share < 0.75; };
  for (const bool left : {true, false}) {
    const cv::Matx33d& K = left ? calibration.left.K : calibration.right.K;
    if (near_middle(K(0, 2) / size.width) && near_middle(K(1, 2) / size.height)) continue;
    return fmt::format(
        "{}: the {} camera's principal point is ({:.6g}, {:.6g}) px, not in the middle half of pictures "
        "of {} x {} px",
        calibration.path, left ? "left" : "right", K(0, 2), K(1, 2), size.width, size.height);
  }
  return {};
}

void judge_principal_points(const StereoCalibration& calibration, cv::Size size, std::vector<std::string>& warnings) {
  const std::string far = far_principal_point(calibration, size);
  if (far.empty()) return;
  if (!calibration.image_size) {
    throw ConfigurationError(far + "; allowed: there, where the file states no image size (was it made for another?)");
  }
  warnings.push_back(far + ": right only if they are cut out of larger ones");
}

}  // namespace

ChosenCameras choose_cameras(const CameraGeometry& geometry, cv::Size picture_size) {
  require_size(geometry, picture_size);
  ChosenCameras chosen;
  std::string pictures = "pictures are taken as rectified";
  if (geometry.calibration) {
    const StereoCalibration calibration = with_rectification(*geometry.calibration, picture_size);
    chosen.rectifier.emplace(calibration, picture_size);
    chosen.camera = rectified_camera(calibration);
    chosen.warnings = calibration.warnings;
    judge_principal_points(calibration, picture_size, chosen.warnings);
    const SharedView& view = chosen.rectifier->shared_view();
    pictures =
        fmt::format("{:.0f}% of the rectified pictures show something, {:.0f}% of the cameras' pictures are left",
                    100.0 * view.filled, 100.0 * view.kept);
  } else {
    chosen.camera = geometry.as_rectified(picture_size);
  }
  chosen.summary =
      fmt::format("cameras: f {:.1f} px, baseline {:.4f} m; {}", chosen.camera.fx, chosen.camera.baseline, pictures);
  return chosen;
}

}  // namespace markservo::stereo_camera
