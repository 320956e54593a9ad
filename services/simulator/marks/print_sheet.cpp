#include "services/simulator/marks/print_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/marks/mark_texture.hpp"

namespace markservo::simulator {
namespace {

constexpr int kLargestTexture_px = 4096;
const cv::Scalar kInk(0, 0, 0);

class Sheet {
 public:
  explicit Sheet(const SheetParameters& parameters)
      : p_(parameters), image_(px(p_.height), px(p_.width), CV_8UC3, cv::Scalar::all(255)) {}

  int px(double metres) const { return static_cast<int>(std::lround(metres * p_.dots_per_metre)); }
  cv::Mat& image() { return image_; }

  void line(double x0, double y0, double x1, double y1) {
    cv::line(image_, {px(x0), px(y0)}, {px(x1), px(y1)}, kInk, std::max(1, px(p_.line)));
  }
  // `height`: m, of a capital letter; (x, y): of its foot, m.
  void write(const std::string& text, double x, double y, double height) {
    constexpr double kHersheyCapital_px = 21.0;  // of OpenCV's font at scale 1
    const double scale = px(height) / kHersheyCapital_px;
    cv::putText(image_, text, {px(x), px(y)}, cv::FONT_HERSHEY_SIMPLEX, scale, kInk, std::max(1, px(2.0 * p_.line)),
                cv::LINE_AA);
  }

 private:
  SheetParameters p_;
  cv::Mat image_;
};

// Lines to cut along, which do not touch the mark.
void draw_ticks(const SheetParameters& p, double size, Sheet& sheet) {
  for (const double side : {0.0, size}) {
    const double at = p.margin + side;
    for (const auto& [from, to] : {std::pair{p.margin - p.tick, p.margin - 0.2 * p.tick},
                                   std::pair{p.margin + size + 0.2 * p.tick, p.margin + size + p.tick}}) {
      sheet.line(from, at, to, at);
      sheet.line(at, from, at, to);
    }
  }
}

}  // namespace

cv::Mat print_sheet(const robot::MarkDescription& mark, const PrintScene& print, const SheetParameters& p) {
  const double largest = p.width - 2.0 * p.margin;
  if (mark.size > largest) {
    throw ConfigurationError(fmt::format("mark {:.40} has an edge of {:.3f} m; allowed on a sheet: up to {:.3f} m",
                                         mark.name, mark.size, largest));
  }
  Sheet sheet(p);
  const int edge = sheet.px(mark.size);
  const Texture texture = mark_texture(mark, print, std::clamp(edge, 16, kLargestTexture_px));
  cv::Mat printed(texture.edge, texture.edge, CV_8UC3, const_cast<std::uint8_t*>(texture.rgb.data()));
  cv::cvtColor(printed, printed, cv::COLOR_RGB2BGR);
  cv::resize(printed, printed, {edge, edge}, 0.0, 0.0, cv::INTER_CUBIC);
  printed.copyTo(sheet.image()({sheet.px(p.margin), sheet.px(p.margin), edge, edge}));
  draw_ticks(p, mark.size, sheet);

  const double ruler_y = p.margin + mark.size + 0.020;
  sheet.line(p.margin, ruler_y, p.margin + p.ruler, ruler_y);
  for (const double end : {p.margin, p.margin + p.ruler}) {
    sheet.line(end, ruler_y - 0.5 * p.tick, end, ruler_y + 0.5 * p.tick);
  }
  const std::string words = fmt::format("{:.40}: {:.1f} mm. This line is {:.0f} mm long: print at 100%.", mark.name,
                                        1e3 * mark.size, 1e3 * p.ruler);
  sheet.write(words, p.margin, ruler_y + 0.008, 0.0025);
  return sheet.image();
}

}  // namespace markservo::simulator
