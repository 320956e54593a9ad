#include "services/mark-detector/picture/picture.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "services/mark-detector/blobs/hole_filler.hpp"
#include "services/mark-detector/views/view_finder.hpp"

namespace markservo::mark_detector {
namespace {

constexpr std::size_t kMaxBlobMasks = 64;
const cv::Scalar kLine(255, 0, 255);  // magenta: no mark of the default robot has it

nlohmann::ordered_json json_of(const Shape& shape) {
  return {{"x", shape.x}, {"y", shape.y}, {"width", shape.width}, {"height", shape.height}, {"area", shape.area},
          {"u", shape.u}, {"v", shape.v}, {"m_uu", shape.m_uu},   {"m_uv", shape.m_uv},     {"m_vv", shape.m_vv}};
}

nlohmann::ordered_json json_of(const View& view, const BlobList& blobs, bool all_blobs) {
  nlohmann::ordered_json json{{"seen", view.seen}};
  if (view.seen) {
    json["clipped"] = view.clipped;
    json.update(json_of(view.shape));
  }
  if (all_blobs) {
    json["blobs"] = nlohmann::ordered_json::array();
    for (const Blob& blob : blobs.blobs) json["blobs"].push_back(json_of(blob.shape));
  }
  return json;
}

cv::Mat mask_of(const Region& region, cv::Size size) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  for (int j = 0; j < region.height; ++j) {
    std::uint8_t* row = mask.ptr<std::uint8_t>(region.y + j);
    for (int i = 0; i < region.width; ++i) row[region.x + i] = region.inside.test(i, j) ? 255 : 0;
  }
  return mask;
}

void draw(cv::Mat& canvas, const Finding& finding, const View& view) {
  if (!view.seen) return;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask_of(view.region, canvas.size()), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(canvas, contours, -1, cv::Scalar(255, 255, 255), 1);
  cv::rectangle(canvas, {view.shape.x - 2, view.shape.y - 2, view.shape.width + 4, view.shape.height + 4}, kLine, 1);
  const cv::Point centre(cvRound(view.shape.u), cvRound(view.shape.v));
  cv::drawMarker(canvas, centre, kLine, cv::MARKER_CROSS, 9, 1);
  const cv::Point corner(view.shape.x, std::max(12, view.shape.y - 6));
  cv::putText(canvas, finding.name, corner, cv::FONT_HERSHEY_SIMPLEX, 0.45, cv::Scalar(0, 0, 0), 3, cv::LINE_AA);
  cv::putText(canvas, finding.name, corner, cv::FONT_HERSHEY_SIMPLEX, 0.45, cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
}

void add_masks(const std::string& name, const View& view, const BlobList& blobs, cv::Size size, bool all_blobs,
               std::vector<NamedMask>& masks) {
  if (view.seen) masks.push_back({name + ".png", mask_of(view.region, size)});
  if (!all_blobs) return;
  for (std::size_t i = 0; i < std::min(kMaxBlobMasks, blobs.blobs.size()); ++i) {
    const Blob& blob = blobs.blobs[i];
    const auto hole = static_cast<std::int64_t>(ViewParameters{}.hole_fraction * blob.shape.area);
    HoleFiller filler;
    std::vector<PixelRun> runs;
    filler.fill(blobs.runs_of(blob), hole, runs);
    Region region;
    make_region(runs, shape_of(runs), 0, size.width, size.height, region);
    masks.push_back({name + "-blob-" + std::to_string(i) + ".png", mask_of(region, size)});
  }
}

}  // namespace

ImageView view_of(const cv::Mat& image) {
  return {image.ptr<std::uint8_t>(), image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step[0])};
}

nlohmann::ordered_json report(const Output& output, bool has_right, bool all_blobs) {
  nlohmann::ordered_json marks = nlohmann::ordered_json::array();
  for (const Finding& finding : output.marks) {
    nlohmann::ordered_json mark{
        {"name", finding.name},
        {"role", finding.role == robot::MarkRole::kTarget ? "target" : "manipulator"},
        {"separability", finding.separability},
        {"reason", finding.reason},
        {"left", json_of(finding.left, finding.left_blobs, all_blobs)},
    };
    if (has_right) mark["right"] = json_of(finding.right, finding.right_blobs, all_blobs);
    marks.push_back(std::move(mark));
  }
  return marks;
}

cv::Mat annotate(const cv::Mat& left, const cv::Mat& right, const Output& output) {
  cv::Mat canvas(left.rows, left.cols + right.cols, CV_8UC3);
  cv::Mat left_half = canvas(cv::Rect(0, 0, left.cols, left.rows));
  left.copyTo(left_half);
  for (const Finding& finding : output.marks) draw(left_half, finding, finding.left);
  if (!right.empty()) {
    cv::Mat right_half = canvas(cv::Rect(left.cols, 0, right.cols, right.rows));
    right.copyTo(right_half);
    for (const Finding& finding : output.marks) draw(right_half, finding, finding.right);
  }
  return canvas;
}

std::vector<NamedMask> masks(const Output& output, cv::Size size, bool all_blobs) {
  std::vector<NamedMask> masks;
  for (const Finding& finding : output.marks) {
    add_masks(finding.name + "-left", finding.left, finding.left_blobs, size, all_blobs, masks);
    add_masks(finding.name + "-right", finding.right, finding.right_blobs, size, all_blobs, masks);
  }
  return masks;
}

}  // namespace markservo::mark_detector
