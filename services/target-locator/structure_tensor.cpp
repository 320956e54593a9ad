#include "services/target-locator/structure_tensor.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace markservo::target_locator {
namespace {

constexpr int kRadius = 2;
// exp(-k^2 / 2), k = -2..2, divided by its sum.
constexpr std::array<float, 5> kGaussian = {0.05448868F, 0.24420134F, 0.40261995F, 0.24420134F, 0.05448868F};

// Three rows of products smoothed along the rows; a ring of five of them feeds the smoothing down the columns.
struct SmoothedRow {
  std::vector<float> cc;
  std::vector<float> cr;
  std::vector<float> rr;
};

void smooth_along(const std::vector<float>& padded, int width, std::vector<float>& out) {
  const float* in = padded.data();
  for (int x = 0; x < width; ++x) {
    out[static_cast<std::size_t>(x)] =
        kGaussian[0] * (in[x] + in[x + 4]) + kGaussian[1] * (in[x + 1] + in[x + 3]) + kGaussian[2] * in[x + 2];
  }
}

}  // namespace

Gradients sobel_gradients(const PlaneImage& image, bool zero_border) {
  const int w = image.width;
  const int h = image.height;
  Gradients gradients{PlaneImage(w, h), PlaneImage(w, h)};
  if (image.empty()) return gradients;
  std::array<std::vector<float>, 3> lines;
  for (auto& line : lines) line.assign(static_cast<std::size_t>(w) + 2, 0.0F);
  const auto load = [&](int y, std::vector<float>& line) {
    if (zero_border && (y < 0 || y >= h)) {
      std::fill(line.begin(), line.end(), 0.0F);
      return;
    }
    const float* in = image.row(std::clamp(y, 0, h - 1));
    std::copy(in, in + w, line.begin() + 1);
    line.front() = zero_border ? 0.0F : in[0];
    line.back() = zero_border ? 0.0F : in[w - 1];
  };
  load(-1, lines[0]);
  load(0, lines[1]);
  for (int y = 0; y < h; ++y) {
    load(y + 1, lines[2]);
    const float* above = lines[0].data();
    const float* here = lines[1].data();
    const float* below = lines[2].data();
    float* gc = gradients.column.row(y);
    float* gr = gradients.row.row(y);
    for (int x = 0; x < w; ++x) {
      gc[x] = 0.125F * ((above[x + 2] - above[x]) + 2.0F * (here[x + 2] - here[x]) + (below[x + 2] - below[x]));
      gr[x] = 0.125F * ((below[x] - above[x]) + 2.0F * (below[x + 1] - above[x + 1]) + (below[x + 2] - above[x + 2]));
    }
    std::rotate(lines.begin(), lines.begin() + 1, lines.end());
  }
  return gradients;
}

CornerMeasures foerstner(const Gradients& gradients, float trace_floor) {
  const int w = gradients.column.width;
  const int h = gradients.column.height;
  CornerMeasures measures{PlaneImage(w, h), PlaneImage(w, h)};
  if (w <= 0 || h <= 0) return measures;
  const auto size = static_cast<std::size_t>(w);
  // Beyond the border gradients are 0, so a padded line starts and ends with zeros.
  std::vector<float> cc(size + std::size_t{2} * kRadius, 0.0F);
  std::vector<float> cr(cc);
  std::vector<float> rr(cc);
  const SmoothedRow zero{std::vector<float>(size), std::vector<float>(size), std::vector<float>(size)};
  std::array<SmoothedRow, 5> ring = {zero, zero, zero, zero, zero};
  for (int y = -kRadius; y < h; ++y) {
    const int next = y + kRadius;
    SmoothedRow& newest = ring[4];
    if (next < h) {
      const float* gc = gradients.column.row(next);
      const float* gr = gradients.row.row(next);
      float* pcc = cc.data() + kRadius;
      float* pcr = cr.data() + kRadius;
      float* prr = rr.data() + kRadius;
      for (int x = 0; x < w; ++x) {
        pcc[x] = gc[x] * gc[x];
        pcr[x] = gc[x] * gr[x];
        prr[x] = gr[x] * gr[x];
      }
      smooth_along(cc, w, newest.cc);
      smooth_along(cr, w, newest.cr);
      smooth_along(rr, w, newest.rr);
    } else {
      newest = zero;
    }
    if (y >= 0) {
      float* weight = measures.weight.row(y);
      float* roundness = measures.roundness.row(y);
      const auto down = [&ring](std::vector<float> SmoothedRow::*product, int x) {
        const auto i = static_cast<std::size_t>(x);
        return kGaussian[0] * ((ring[0].*product)[i] + (ring[4].*product)[i]) +
               kGaussian[1] * ((ring[1].*product)[i] + (ring[3].*product)[i]) + kGaussian[2] * (ring[2].*product)[i];
      };
      for (int x = 0; x < w; ++x) {
        const float a = down(&SmoothedRow::rr, x);
        const float b = down(&SmoothedRow::cr, x);
        const float c = down(&SmoothedRow::cc, x);
        const float trace = a + c;
        const float determinant = std::max(0.0F, a * c - b * b);
        const bool textured = trace >= trace_floor && trace > 0.0F;
        const float inverse = textured ? 1.0F / trace : 0.0F;
        weight[x] = determinant * inverse;
        roundness[x] = 4.0F * determinant * inverse * inverse;
      }
    }
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }
  return measures;
}

}  // namespace markservo::target_locator
