// STEREO_FRAME all the way through the detector's node: raw and JPEG frames, whole and damaged. The bus or the node
// refuses a frame, or it is answered once.

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>

#include "services/mark-detector/mark_detector_node.hpp"
#include "tests/fuzz/damage.hpp"
#include "tests/fuzz/node_on_bus.hpp"
#include "tests/fuzz/numbers.hpp"
#include "tests/fuzz/painted_pair.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::mark_detector {
namespace {

using fuzz::require;

constexpr int kMaxSide = 96;  // px: what large frames do is known from small ones
constexpr int kMaxFrames = 3;

std::vector<std::uint8_t> raw(const fuzz::PaintedImage& image) {
  std::vector<std::uint8_t> bytes;
  for (int v = 0; v < image.height; ++v) {
    const auto row = image.bgr.begin() + v * image.stride;
    bytes.insert(bytes.end(), row, row + 3 * std::ptrdiff_t{image.width});
  }
  return bytes;
}

std::vector<std::uint8_t> jpeg(FuzzedDataProvider& data, std::vector<std::uint8_t> pixels, int width, int height) {
  const cv::Mat image(height, width, CV_8UC3, pixels.data());
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes,
               {cv::IMWRITE_JPEG_QUALITY, 90 - data.ConsumeIntegralInRange(0, 90), cv::IMWRITE_JPEG_PROGRESSIVE,
                data.ConsumeBool() ? 1 : 0});
  if (data.ConsumeBool()) fuzz::damage(data, bytes);
  return bytes;
}

StereoFrame take_frame(FuzzedDataProvider& data, int number) {
  const int width = kMaxSide - data.ConsumeIntegralInRange(0, kMaxSide - 1);
  const int height = kMaxSide - data.ConsumeIntegralInRange(0, kMaxSide - 1);
  const fuzz::PaintedPair pair = fuzz::paint_pair(data, width, height);
  StereoFrame frame{};
  frame.utime = 1000 * (number + 1);
  frame.session = 1;
  frame.seq = number + 1;
  frame.calibration = {fuzz::number(data, 784.0, 1.0, 1e4),  fuzz::number(data, 784.0, 1.0, 1e4),
                       fuzz::number(data, 319.5, -1e3, 1e3), fuzz::number(data, 319.5, -1e3, 1e3),
                       fuzz::number(data, 239.5, -1e3, 1e3), fuzz::number(data, 0.065, 1e-3, 1.0)};
  frame.width = width;
  frame.height = height;
  frame.left = raw(pair.left);
  frame.right = raw(pair.right);
  frame.encoding = StereoFrame::ENCODING_BGR8;
  if (data.ConsumeBool()) {
    frame.encoding = StereoFrame::ENCODING_JPEG;
    frame.left = jpeg(data, std::move(frame.left), width, height);
    frame.right = jpeg(data, std::move(frame.right), width, height);
  }
  frame.left_size = static_cast<std::int32_t>(frame.left.size());
  frame.right_size = static_cast<std::int32_t>(frame.right.size());
  return frame;
}

// Damage may turn a frame into a valid one of many megapixels: slow, and nothing new.
bool is_small(const std::vector<std::uint8_t>& bytes) {
  const auto decoded = bus::safe_decode<StereoFrame>(bytes.data(), bytes.size());
  return !decoded.ok || std::max(decoded.message.width, decoded.message.height) <= 2 * kMaxSide;
}

void run(FuzzedDataProvider& data) {
  fuzz::NodeOnBus<MarkDetectorNode> node(channels::kStereoFrame);
  std::int64_t answers = 0;
  node.bus().on_each(channels::kMarkDetection, [&answers](const MarkDetection&) { ++answers; });
  const int num_frames = data.ConsumeIntegralInRange(1, kMaxFrames);
  for (int k = 0; k < num_frames; ++k) {
    std::vector<std::uint8_t> bytes = fuzz::encoded(take_frame(data, k));
    if (data.ConsumeIntegralInRange(0, 3) == 3) fuzz::damage(data, bytes);
    if (!is_small(bytes)) continue;
    const auto before = node.counts();
    const std::int64_t answered_before = answers;
    node.send({std::move(bytes)});
    const auto after = node.counts();
    const std::int64_t accepted = after.accepted - before.accepted;
    const std::int64_t refused = after.refused - before.refused;
    require(accepted <= 1 && refused <= 1, "a frame is handed over at most once");
    require(answers - answered_before == (accepted == 1 && refused == 0 ? 1 : 0),
            "a frame that is not refused is answered once, and by a message that keeps the rules");
  }
}

}  // namespace
}  // namespace markservo::mark_detector

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider data(bytes, size);
  markservo::mark_detector::run(data);
  return 0;
}
