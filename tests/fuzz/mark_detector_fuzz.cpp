// The detector's core: any image pairs, marks and parameters, frame after frame with one memory.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/fuzz/numbers.hpp"
#include "tests/fuzz/painted_pair.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::mark_detector {
namespace {

using fuzz::require;

constexpr int kMaxWidth = 200;   // px
constexpr int kMaxHeight = 150;  // px
constexpr int kMaxFrames = 4;
constexpr double kTiny = 1e-6;  // relative, of sums of squares

robot::MarkDescription take_mark(FuzzedDataProvider& data, int index) {
  robot::MarkDescription mark;
  mark.name = std::to_string(index);
  mark.role = data.ConsumeBool() ? robot::MarkRole::kManipulator : robot::MarkRole::kTarget;
  mark.surface = data.ConsumeBool() ? robot::MarkSurface::kFree : robot::MarkSurface::kPlane;
  mark.size = fuzz::number(data, 0.025, 0.0, 0.1);
  robot::ColourInterval& colour = mark.colour;
  constexpr double kHues[] = {345.0, 95.0, 200.0, 40.0};  // red, green, blue, yellow
  colour.hue_min_deg = fuzz::number(data, kHues[index % 4], 0.0, 360.0);
  colour.hue_max_deg = fuzz::number(data, std::fmod(colour.hue_min_deg + 45.0, 360.0), 0.0, 360.0);
  colour.saturation_min = fuzz::number(data, 0.4, 0.0, 1.0);
  colour.saturation_max = fuzz::number(data, 1.0, 0.0, 1.0);
  colour.value_min = fuzz::number(data, 0.15, 0.0, 1.0);
  colour.value_max = fuzz::number(data, 1.0, 0.0, 1.0);
  return mark;
}

Parameters take_parameters(FuzzedDataProvider& data) {
  Parameters parameters;
  parameters.equalise = !data.ConsumeBool();
  if (!data.ConsumeBool()) return parameters;
  parameters.histogram_rows = data.ConsumeIntegralInRange(0, 200);
  parameters.chroma_min = data.ConsumeIntegralInRange(0, 255);
  parameters.views.min_area = data.ConsumeIntegralInRange<std::int64_t>(0, 300);
  parameters.views.hole_fraction = data.ConsumeFloatingPointInRange(0.0, 1.0);
  parameters.views.noise_hole = data.ConsumeIntegralInRange<std::int64_t>(0, 40);
  parameters.search.memory_frames = data.ConsumeIntegralInRange(0, 3);
  parameters.search.full_scan_every = data.ConsumeIntegralInRange(0, 4);
  parameters.search.coarse_rows = data.ConsumeIntegralInRange(0, 10);
  parameters.search.track_margin = data.ConsumeIntegralInRange(-1, 60);
  parameters.adapt = data.ConsumeBool();
  parameters.views.selection.max_candidates = data.ConsumeIntegralInRange(-1, 64);
  parameters.views.selection.row_tolerance = data.ConsumeFloatingPointInRange(0.0, 200.0);
  parameters.patch.margin = data.ConsumeIntegralInRange(-1, 300);
  parameters.patch.limit = data.ConsumeIntegralInRange(0, 256);
  parameters.patch.budget = data.ConsumeIntegralInRange<std::int64_t>(0, 300000);
  return parameters;
}

ImageView view_of(const fuzz::PaintedImage& image) {
  return {image.bgr.data(), image.width, image.height, image.stride};
}

bool inside(int x, int y, int width, int height, const ImageView& image) {
  return x >= 0 && y >= 0 && width >= 1 && height >= 1 && x + width <= image.width && y + height <= image.height;
}

void check_shape(const Shape& shape, const ImageView& image) {
  require(inside(shape.x, shape.y, shape.width, shape.height, image), "a box lies inside the image");
  for (const double value : {shape.area, shape.u, shape.v, shape.m_uu, shape.m_uv, shape.m_vv}) {
    require(std::isfinite(value), "a shape's numbers are finite");
  }
  require(shape.area > 0.0, "what is seen has an area");
  require(shape.u >= 0.0 && shape.u <= image.width - 1.0 && shape.v >= 0.0 && shape.v <= image.height - 1.0,
          "a centroid lies inside the image");
  const double slack = kTiny * (1.0 + shape.m_uu + shape.m_vv);
  require(shape.m_uu >= -slack && shape.m_vv >= -slack, "second moments are positive");
  require(shape.m_uu * shape.m_vv - shape.m_uv * shape.m_uv >= -slack * slack - slack * (shape.m_uu + shape.m_vv),
          "second moments are positive semidefinite");
}

void check_blobs(const BlobList& list, const ImageView& image, const Parameters& parameters) {
  require(list.blobs.size() <= BlobParameters{}.max_blobs, "no more blobs are kept than the limit");
  double last = static_cast<double>(list.largest_area);
  for (const Blob& blob : list.blobs) {
    check_shape(blob.shape, image);
    require(blob.shape.area >= static_cast<double>(parameters.views.min_area), "a blob has the least area");
    require(blob.shape.area <= static_cast<double>(blob.shape.width) * blob.shape.height, "a blob fits its box");
    require(blob.shape.area <= last, "blobs come the largest first");
    last = blob.shape.area;
  }
}

void check_patch(const Patch& patch, const ImageView& image, const Parameters& parameters) {
  if (patch.scale == 0) return require(patch.bgr.empty() && patch.mask.empty(), "no patch has no pixels");
  require(patch.scale > 0, "a scale is positive");
  require(patch.width <= parameters.patch.limit && patch.height <= parameters.patch.limit, "a patch keeps its limit");
  require(inside(patch.x, patch.y, patch.width * patch.scale, patch.height * patch.scale, image),
          "a patch lies inside the image");
  const auto width = static_cast<std::size_t>(patch.width);
  const auto height = static_cast<std::size_t>(patch.height);
  require(patch.bgr.size() == width * height * 3, "a patch has its pixels");
  require(patch.mask.size() == (width + 7) / 8 * height, "a patch has its mask");
}

void check_view(const View& view, const ImageView& image, const Parameters& parameters) {
  check_patch(view.patch, image, parameters);
  if (!view.seen) return require(view.patch.scale == 0, "what is not seen has no patch");
  check_shape(view.shape, image);
  const Region& region = view.region;
  require(inside(region.x, region.y, region.width, region.height, image), "a region lies inside the image");
  require(region.inside.width() == region.width && region.inside.height() == region.height, "a region has its mask");
  require(view.shape.area <= static_cast<double>(region.width) * region.height * (1.0 + kTiny),
          "an area fits its region");
  require(view.shape.x >= region.x && view.shape.x + view.shape.width <= region.x + region.width &&
              view.shape.y >= region.y && view.shape.y + view.shape.height <= region.y + region.height,
          "a box lies inside its region");
  require(region.inside.count() > 0, "what is seen has a mask");
}

void check_output(const Output& output, const Input& input, std::size_t num_marks, const Parameters& parameters) {
  require(output.marks.size() == num_marks, "every mark is listed");
  const bool single = input.right.empty();
  std::int64_t patch_bytes = 0;
  for (const Finding& finding : output.marks) {
    check_view(finding.left, input.left, parameters);
    check_blobs(finding.left_blobs, input.left, parameters);
    if (!single) {
      check_view(finding.right, input.right, parameters);
      check_blobs(finding.right_blobs, input.right, parameters);
    } else {
      require(!finding.right.seen, "an absent image shows nothing");
    }
    require(finding.separability >= 0.0 && finding.separability <= 1.0, "separability is between 0 and 1");
    const bool complete = finding.left.seen && (single || finding.right.seen);
    require(complete == finding.reason.empty(), "there is a reason exactly where a view is missing");
    require(finding.left.patch.scale == finding.right.patch.scale, "both patches have one scale");
    for (const View* view : {&finding.left, &finding.right}) {
      patch_bytes += static_cast<std::int64_t>(view->patch.bgr.size() + view->patch.mask.size());
    }
  }
  require(patch_bytes <= std::max<std::int64_t>(0, parameters.patch.budget), "all patches keep the budget");
}

void run(FuzzedDataProvider& data) {
  std::vector<robot::MarkDescription> marks;
  const int num_marks = data.ConsumeIntegralInRange(1, 9);
  marks.reserve(static_cast<std::size_t>(num_marks));
  for (int i = 0; i < num_marks; ++i) marks.push_back(take_mark(data, i));
  const Parameters parameters = take_parameters(data);
  std::optional<MarkDetector> detector;
  try {
    detector.emplace(marks, parameters);
  } catch (const std::invalid_argument&) {
    return;  // told why, as promised
  }

  State state;
  const int num_frames = data.ConsumeIntegralInRange(1, kMaxFrames);
  int width = data.ConsumeIntegralInRange(1, kMaxWidth);
  int height = data.ConsumeIntegralInRange(1, kMaxHeight);
  for (int k = 0; k < num_frames; ++k) {
    if (data.ConsumeIntegralInRange(0, 7) == 7) {
      width = data.ConsumeIntegralInRange(1, kMaxWidth);
      height = data.ConsumeIntegralInRange(1, kMaxHeight);
    }
    const fuzz::PaintedPair pair = fuzz::paint_pair(data, width, height);
    Input input;
    input.left = view_of(pair.left);
    if (data.ConsumeIntegralInRange(0, 7) < 7) input.right = view_of(pair.right);
    if (data.ConsumeIntegralInRange(0, 3) > 0) {
      input.stereo = geometry::StereoCamera{
          fuzz::number(data, 784.0, 1.0, 1e4),        784.0,        fuzz::number(data, 0.5 * width, -1e3, 1e3),
          fuzz::number(data, 0.5 * width, -1e3, 1e3), 0.5 * height, fuzz::number(data, 0.065, 1e-3, 1.0)};
    }
    check_output(detector->step(input, state), input, marks.size(), parameters);
  }
}

}  // namespace
}  // namespace markservo::mark_detector

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider data(bytes, size);
  markservo::mark_detector::run(data);
  return 0;
}
