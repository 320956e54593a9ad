// MARK_DETECTION all the way through the locator's node: what the bus accepts is answered, whatever it says, by one
// TARGET_POSE in one packet and one STEREO_MATCHES.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "services/target-locator/pose_message.hpp"
#include "services/target-locator/target_locator_node.hpp"
#include "tests/fuzz/damage.hpp"
#include "tests/fuzz/node_on_bus.hpp"
#include "tests/fuzz/numbers.hpp"
#include "tests/fuzz/printed_mark.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::target_locator {
namespace {

using fuzz::require;

constexpr int kMaxMarks = 4;

std::int32_t whole(double value) {
  constexpr double kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return std::isnan(value) ? 0 : static_cast<std::int32_t>(std::clamp(value, kLeast, kMost));
}

MarkView message_of(FuzzedDataProvider& data, const View& view, const fuzz::PrintedPatch& patch) {
  MarkView message{};
  message.seen = view.seen ? 1 : 0;
  message.clipped = view.clipped ? 1 : 0;
  message.x = whole(view.x);
  message.y = whole(view.y);
  message.width = whole(view.width);
  message.height = whole(view.height);
  message.area = fuzz::number(data, view.width * view.height, 0.0, 1e6);
  message.u = fuzz::number(data, view.centre_u(), -1e3, 1e3);
  message.v = fuzz::number(data, view.centre_v(), -1e3, 1e3);
  if (data.ConsumeIntegralInRange(0, 15) == 15) return message;
  message.patch.x = whole(view.patch.frame.x);
  message.patch.y = whole(view.patch.frame.y);
  message.patch.scale = whole(view.patch.frame.scale);
  message.patch.width = patch.width;
  message.patch.height = patch.height;
  message.patch.bgr_size = static_cast<std::int32_t>(patch.bgr.size());
  message.patch.bgr = patch.bgr;
  message.patch.mask_size = static_cast<std::int32_t>(patch.mask.size());
  message.patch.mask = patch.mask;
  return message;
}

MarkDetection take_detection(FuzzedDataProvider& data) {
  MarkDetection detection{};
  detection.utime = 1000;
  detection.session = 1;
  detection.seq = 1;
  detection.frame_session = 1;
  detection.frame_seq = 1;
  detection.frame_utime = 1000;
  detection.width = 640;
  detection.height = 480;
  detection.calibration = {fuzz::number(data, 784.0, 1.0, 1e4),  fuzz::number(data, 784.0, 1.0, 1e4),
                           fuzz::number(data, 319.5, -1e3, 1e3), fuzz::number(data, 319.5, -1e3, 1e3),
                           fuzz::number(data, 239.5, -1e3, 1e3), fuzz::number(data, 0.065, 1e-3, 1.0)};
  const int num_marks = data.ConsumeIntegralInRange(1, kMaxMarks);
  for (int i = 0; i < num_marks; ++i) {
    DetectedMark mark{};
    mark.name = data.ConsumeIntegralInRange(0, 3) < 3 ? "red_book" : data.ConsumeRandomLengthString(2000);
    mark.role = data.ConsumeIntegralInRange<std::int8_t>(0, 1);
    mark.separability = fuzz::number(data, 1.0, 0.0, 1.0);
    fuzz::PrintedMark printed;
    fuzz::print_mark(data, true, printed);
    mark.left = message_of(data, printed.observation.left, printed.left);
    mark.right = message_of(data, printed.observation.right, printed.right);
    detection.marks.push_back(std::move(mark));
  }
  detection.num_marks = static_cast<std::int32_t>(detection.marks.size());
  return detection;
}

void run(FuzzedDataProvider& data) {
  fuzz::NodeOnBus<TargetLocatorNode> node(channels::kMarkDetection);
  int poses = 0;
  int matches = 0;
  node.bus().on_each(channels::kTargetPose, [&poses](const TargetPose& pose) {
    ++poses;
    require(pose.getEncodedSize() <= kMaxPoseBytes, "a TARGET_POSE fits one packet");
  });
  node.bus().on_each(channels::kStereoMatches, [&matches](const StereoMatches&) { ++matches; });
  std::vector<std::uint8_t> bytes = fuzz::encoded(take_detection(data));
  if (data.ConsumeIntegralInRange(0, 3) == 3) fuzz::damage(data, bytes);
  node.send({std::move(bytes)});
  const auto counts = node.counts();
  require(counts.accepted == 0 || counts.refused == 0, "the node can work on what the bus accepts");
  require(poses == counts.accepted && matches == counts.accepted, "what is accepted is answered once");
}

}  // namespace
}  // namespace markservo::target_locator

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider data(bytes, size);
  markservo::target_locator::run(data);
  return 0;
}
