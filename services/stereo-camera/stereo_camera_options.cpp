#include "services/stereo-camera/stereo_camera_options.hpp"

#include "common/bus/options.hpp"

namespace markservo::stereo_camera {
namespace {

void add_source_options(const bus::Options& add, SourceOptions& source) {
  add.option("--left-device", source.left_device, "Left camera, for example /dev/video0");
  add.option("--right-device", source.right_device, "Right camera, for example /dev/video2");
  add.option("--device", source.device, "One camera that delivers both views (with --side-by-side)");
  add.option("--left", source.left, "Left video, picture, or pattern as left_%02d.png");
  add.option("--right", source.right, "Right video, picture, or pattern");
  add.option("--input", source.input, "One video, picture or pattern with both views (with --side-by-side)");
  add.flag("--side-by-side", source.side_by_side, "Both views in one picture, the left view in the left half");
  add.flag("--loop", source.loop, "Begin files again at their end");
  add.option("--rate", source.rate_hz,
             "Pairs per second, Hz; default: videos by the times they state, pictures 10, cameras 30");
  add.option("--offset-s", source.offset_s,
             "What the right video's time is more than the left's at the same moment, s; default: 0");
  add.flag("--estimate-offset", source.estimate_offset, "Find the offset by what moves in both videos' first minute");
  add.flag("--wait-for-device", source.wait_for_device, "Wait for a camera that is not there at the start");
  add.option("--width", source.width, "Width asked of a camera's view, px; default: as calibrated").in_range(0, 16384);
  add.option("--height", source.height, "Height asked of a camera's view, px; default: as calibrated")
      .in_range(0, 16384);
  add.option("--exposure", source.camera.exposure, "Fixed exposure in the driver's unit; default: automatic");
  add.option("--white-balance", source.camera.white_balance_K, "Fixed white balance, K; default: held as it is");
  add.flag("--auto-white-balance", source.camera.auto_white_balance, "Let cameras balance white by themselves");
}

void add_geometry_options(const bus::Options& add, GeometryOptions& geometry) {
  add.option("--calibration", geometry.calibration,
             "Stereo calibration to rectify by: one file of OpenCV (K1 D1 K2 D2 R T; YAML, XML or JSON), or two of "
             "ROS's camera_info, the left camera's first");
  add.option("--intrinsics", geometry.intrinsics, "M1 D1 M2 D2 as OpenCV's stereo_calib sample writes them");
  add.option("--extrinsics", geometry.extrinsics, "R T R1 R2 P1 P2 as that sample writes them");
  add.option("--board-square", geometry.board_square,
             "Edge of the calibration board's squares, m, where T counts in squares or the file has a square_size");
  add.option("--metres-per-unit", geometry.metres_per_unit,
             "Unit of the calibration's T, m: 0.001 for a board given in mm, 0.01 in cm, 0.0254 in inches; default: 1");
  add.option(
         "--lens", geometry.lens,
         "Model of the calibration's distortion: pinhole, fisheye (that of cv::fisheye), or auto: as the file says, "
         "else pinhole")
      .one_of({"auto", "pinhole", "fisheye"})
      .show_default();
  add.flag("--accept-rms", geometry.accept_any_error,
           "Take a calibration with an error above 0.5 px, or with none stated");
  add.option("--fx", geometry.fx, "Focal length of rectified pictures, px; replaces robot.yaml's cameras");
  add.option("--fy", geometry.fy, "Focal length along v, px; default: --fx");
  add.option("--cx-left", geometry.cx_left, "Principal column on the left, px; default: the middle");
  add.option("--cx-right", geometry.cx_right, "Principal column on the right, px; default: the middle");
  add.option("--cy", geometry.cy, "Principal row, px; default: the middle");
  add.option("--baseline", geometry.baseline, "Right lens minus left lens, m");
}

}  // namespace

void add_stereo_camera_options(CLI::App& app, StereoCameraOptions& options) {
  const bus::Options add(app);
  add_source_options(add, options.source);
  add_geometry_options(add, options.geometry);
  add.option("--encoding", options.encoding, "raw, jpeg, or auto: raw where the network's buffers hold it")
      .one_of({"auto", "raw", "jpeg"})
      .show_default();
  add.option("--jpeg-quality", options.jpeg_quality, "1 to 100").in_range(1, 100).show_default();
  add.option("--count", options.count, "Stop after this many pairs; 0: no limit").not_negative().show_default();
  add.flag("--once", options.once, "Stop after one pair");
}

}  // namespace markservo::stereo_camera
