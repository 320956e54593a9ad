#include "services/stereo-camera/stereo_camera_options.hpp"

#include "common/bus/options.hpp"

namespace markservo::stereo_camera {

void add_stereo_camera_options(CLI::App& app, StereoCameraOptions& options) {
  const bus::Options add(app);
  SourceOptions& source = options.source;
  GeometryOptions& geometry = options.geometry;
  add.option("--left-device", source.left_device, "Left camera, for example /dev/video0");
  add.option("--right-device", source.right_device, "Right camera, for example /dev/video2");
  add.option("--device", source.device, "One camera that delivers both views (with --side-by-side)");
  add.option("--left", source.left, "Left video, picture, or pattern as left_%02d.png");
  add.option("--right", source.right, "Right video, picture, or pattern");
  add.option("--input", source.input, "One video, picture or pattern with both views (with --side-by-side)");
  add.flag("--side-by-side", source.side_by_side, "Both views in one picture, the left view in the left half");
  add.flag("--loop", source.loop, "Begin files again at their end");
  add.option("--rate", source.rate_hz, "Pairs per second, Hz; default: as the video states, else 10; cameras 30");
  add.flag("--wait-for-device", source.wait_for_device, "Wait for a camera that is not there at the start");
  add.option("--width", source.width, "Width asked of a camera's view, px; default: as calibrated").in_range(0, 16384);
  add.option("--height", source.height, "Height asked of a camera's view, px; default: as calibrated")
      .in_range(0, 16384);
  add.option("--exposure", source.camera.exposure, "Fixed exposure in the driver's unit; default: automatic");
  add.option("--white-balance", source.camera.white_balance_K, "Fixed white balance, K; default: held as it is");
  add.flag("--auto-white-balance", source.camera.auto_white_balance, "Let cameras balance white by themselves");

  add.option("--calibration", geometry.calibration, "OpenCV stereo calibration (YAML or XML) to rectify by");
  add.option("--intrinsics", geometry.intrinsics, "M1 D1 M2 D2 as OpenCV's stereo_calib sample writes them");
  add.option("--extrinsics", geometry.extrinsics, "R T R1 R2 P1 P2 as that sample writes them");
  add.option("--metres-per-unit", geometry.limits.metres_per_unit,
             "Unit of the calibration's T, m (0.001 for a board measured in mm)")
      .show_default();
  add.flag("--accept-rms", geometry.limits.accept_any_error,
           "Take a calibration with an error above 0.5 px, or with none stated");
  add.option("--fx", geometry.fx, "Focal length of rectified pictures, px; replaces robot.yaml's cameras");
  add.option("--fy", geometry.fy, "Focal length along v, px; default: --fx");
  add.option("--cx-left", geometry.cx_left, "Principal column on the left, px; default: the middle");
  add.option("--cx-right", geometry.cx_right, "Principal column on the right, px; default: the middle");
  add.option("--cy", geometry.cy, "Principal row, px; default: the middle");
  add.option("--baseline", geometry.baseline, "Right lens minus left lens, m");

  add.option("--encoding", options.encoding, "raw, jpeg, or auto: raw where the network's buffers hold it")
      .one_of({"auto", "raw", "jpeg"})
      .show_default();
  add.option("--jpeg-quality", options.jpeg_quality, "1 to 100").in_range(1, 100).show_default();
  add.option("--count", options.count, "Stop after this many pairs; 0: no limit").not_negative().show_default();
  add.flag("--once", options.once, "Stop after one pair");
}

}  // namespace markservo::stereo_camera
