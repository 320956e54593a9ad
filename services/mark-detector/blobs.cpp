#include "services/mark-detector/blobs.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace markservo::mark_detector {
namespace {

class DisjointSets {
 public:
  int32_t add() {
    parent_.push_back(static_cast<int32_t>(parent_.size()));
    return parent_.back();
  }
  int32_t root(int32_t i) {
    while (parent_[index(i)] != i) {
      parent_[index(i)] = parent_[index(parent_[index(i)])];
      i = parent_[index(i)];
    }
    return i;
  }
  // The smaller label survives, so that labels are in the order of the regions' first pixels.
  void join(int32_t a, int32_t b) {
    a = root(a);
    b = root(b);
    parent_[index(std::max(a, b))] = std::min(a, b);
  }

 private:
  static std::size_t index(int32_t i) { return static_cast<std::size_t>(i); }
  std::vector<int32_t> parent_;
};

struct LabelledRuns {
  std::vector<PixelRun> runs;
  std::vector<int32_t> labels;  // of each run: its region's first run
};

LabelledRuns label(const BitMask& mask, Connectivity connectivity) {
  LabelledRuns result;
  std::vector<PixelRun>& runs = result.runs;
  DisjointSets sets;
  const int reach = connectivity == Connectivity::kEight ? 1 : 0;
  std::size_t above_begin = 0;
  std::size_t above_end = 0;
  for (int v = 0; v < mask.height(); ++v) {
    const std::size_t row_begin = runs.size();
    std::size_t above = above_begin;
    const int first = mask.row_empty(v) ? mask.width() : mask.next(v, 0, true);
    for (int begin = first; begin < mask.width();) {
      const int end = mask.next(v, begin, false);
      const int32_t own = sets.add();
      runs.push_back({v, begin, end});
      while (above < above_end && runs[above].end + reach <= begin) ++above;
      for (std::size_t i = above; i < above_end && runs[i].begin < end + reach; ++i) {
        sets.join(static_cast<int32_t>(i), own);
      }
      begin = mask.next(v, end, true);
    }
    above_begin = row_begin;
    above_end = runs.size();
  }
  result.labels.reserve(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) result.labels.push_back(sets.root(static_cast<int32_t>(i)));
  return result;
}

// Of each run's region, by the region's first run.
std::vector<int64_t> areas_of(const LabelledRuns& labelled) {
  std::vector<int64_t> areas(labelled.runs.size(), 0);
  for (std::size_t i = 0; i < labelled.runs.size(); ++i) {
    areas[static_cast<std::size_t>(labelled.labels[i])] += labelled.runs[i].end - labelled.runs[i].begin;
  }
  return areas;
}

bool before(const PixelRun& a, const PixelRun& b) {
  return a.v != b.v ? a.v < b.v : a.begin < b.begin;
}

}  // namespace

Shape shape_of(const std::vector<PixelRun>& runs) {
  Shape shape;
  if (runs.empty()) return shape;
  int left = std::numeric_limits<int>::max();
  int right = 0;
  int top = std::numeric_limits<int>::max();
  int bottom = 0;
  for (const PixelRun& run : runs) {
    left = std::min(left, run.begin);
    right = std::max(right, run.end);
    top = std::min(top, run.v);
    bottom = std::max(bottom, run.v + 1);
  }
  // Exact sums from the box's corner; 16384 x 16384 px stay below 2^63.
  const auto squares = [](int64_t n) { return (n - 1) * n * (2 * n - 1) / 6; };  // 0 + 1 + 4 + ... + (n - 1)^2
  int64_t n = 0;
  int64_t sum_u = 0;
  int64_t sum_v = 0;
  int64_t sum_uu = 0;
  int64_t sum_uv = 0;
  int64_t sum_vv = 0;
  for (const PixelRun& run : runs) {
    const int64_t begin = run.begin - left;
    const int64_t end = run.end - left;
    const int64_t v = run.v - top;
    const int64_t count = end - begin;
    const int64_t sum = (begin + end - 1) * count / 2;
    n += count;
    sum_u += sum;
    sum_v += v * count;
    sum_uu += squares(end) - squares(begin);
    sum_uv += v * sum;
    sum_vv += v * v * count;
  }
  const auto number = static_cast<double>(n);
  const double mean_u = static_cast<double>(sum_u) / number;
  const double mean_v = static_cast<double>(sum_v) / number;
  shape.x = left;
  shape.y = top;
  shape.width = right - left;
  shape.height = bottom - top;
  shape.area = number;
  shape.u = left + mean_u;
  shape.v = top + mean_v;
  shape.m_uu = static_cast<double>(sum_uu) / number - mean_u * mean_u;
  shape.m_uv = static_cast<double>(sum_uv) / number - mean_u * mean_v;
  shape.m_vv = static_cast<double>(sum_vv) / number - mean_v * mean_v;
  return shape;
}

BlobList find_blobs(const BitMask& mask, const BlobParameters& parameters) {
  const LabelledRuns labelled = label(mask, parameters.connectivity);
  const std::vector<int64_t> areas = areas_of(labelled);
  BlobList list;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    list.largest_area = std::max(list.largest_area, areas[i]);
    if (areas[i] > 0 && areas[i] >= parameters.min_area) kept.push_back(i);
  }
  std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  if (kept.size() > parameters.max_blobs) kept.resize(parameters.max_blobs);

  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> rank(areas.size(), kNone);
  for (std::size_t i = 0; i < kept.size(); ++i) rank[kept[i]] = i;
  list.blobs.resize(kept.size());
  for (std::size_t i = 0; i < labelled.runs.size(); ++i) {
    const std::size_t k = rank[static_cast<std::size_t>(labelled.labels[i])];
    if (k != kNone) list.blobs[k].runs.push_back(labelled.runs[i]);
  }
  for (Blob& blob : list.blobs) blob.shape = shape_of(blob.runs);
  return list;
}

Blob merge(const std::vector<Blob>& blobs) {
  Blob all;
  for (const Blob& blob : blobs) all.runs.insert(all.runs.end(), blob.runs.begin(), blob.runs.end());
  std::sort(all.runs.begin(), all.runs.end(), before);
  all.shape = shape_of(all.runs);
  return all;
}

std::vector<PixelRun> fill_holes(const Blob& blob, int64_t max_hole) {
  // The blob's complement in its box and one pixel around: what is connected to that rim is outside.
  const int left = blob.shape.x - 1;
  const int top = blob.shape.y - 1;
  BitMask background(blob.shape.width + 2, blob.shape.height + 2);
  std::size_t next = 0;
  for (int v = 0; v < background.height(); ++v) {
    int begin = 0;
    for (; next < blob.runs.size() && blob.runs[next].v - top == v; ++next) {
      background.set_run(v, begin, blob.runs[next].begin - left);
      begin = blob.runs[next].end - left;
    }
    background.set_run(v, begin, background.width());
  }
  const LabelledRuns labelled = label(background, Connectivity::kFour);
  const std::vector<int64_t> areas = areas_of(labelled);
  std::vector<PixelRun> runs = blob.runs;
  for (std::size_t i = 0; i < labelled.runs.size(); ++i) {
    const auto region = static_cast<std::size_t>(labelled.labels[i]);
    const PixelRun& run = labelled.runs[i];
    // The rim is one region, and the very first: it holds the first run.
    if (region != 0 && areas[region] <= max_hole) runs.push_back({run.v + top, run.begin + left, run.end + left});
  }
  if (runs.size() == blob.runs.size()) return runs;
  std::sort(runs.begin(), runs.end(), before);
  std::vector<PixelRun> joined;
  for (const PixelRun& run : runs) {
    if (!joined.empty() && joined.back().v == run.v && joined.back().end == run.begin) {
      joined.back().end = run.end;
    } else {
      joined.push_back(run);
    }
  }
  return joined;
}

}  // namespace markservo::mark_detector
