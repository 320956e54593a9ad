#include "services/mark-detector/blobs/blobs.hpp"

#include <algorithm>
#include <limits>

namespace markservo::mark_detector {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

std::int32_t root(std::vector<std::int32_t>& parents, std::int32_t i) {
  while (parents[index(i)] != i) {
    parents[index(i)] = parents[index(parents[index(i)])];
    i = parents[index(i)];
  }
  return i;
}

// The smaller label survives, so that labels are in the order of the regions' first pixels.
void join(std::vector<std::int32_t>& parents, std::int32_t a, std::int32_t b) {
  a = root(parents, a);
  b = root(parents, b);
  parents[index(std::max(a, b))] = std::min(a, b);
}

bool before(const PixelRun& a, const PixelRun& b) {
  return a.v != b.v ? a.v < b.v : a.begin < b.begin;
}

// Rows without a gap, one run each, enclose nothing.
bool is_solid(RunSpan runs) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].v != runs[i - 1].v + 1) return false;
  }
  return true;
}

}  // namespace

void LabelledRuns::label(const BitMask& mask, Connectivity connectivity) {
  runs.clear();
  labels.clear();
  const int reach = connectivity == Connectivity::kEight ? 1 : 0;
  std::size_t above_begin = 0;
  std::size_t above_end = 0;
  int last_row = -1;
  for (int v = mask.next_used(0); v < mask.height(); v = mask.next_used(v + 1)) {
    if (v != last_row + 1) above_begin = above_end = runs.size();
    last_row = v;
    const std::size_t row_begin = runs.size();
    std::size_t above = above_begin;
    for (int begin = mask.next(v, 0, true); begin < mask.width();) {
      const int end = mask.next(v, begin, false);
      const auto own = static_cast<std::int32_t>(runs.size());
      labels.push_back(own);
      runs.push_back({v, begin, end});
      while (above < above_end && runs[above].end + reach <= begin) ++above;
      for (std::size_t i = above; i < above_end && runs[i].begin < end + reach; ++i) {
        join(labels, static_cast<std::int32_t>(i), own);
      }
      begin = mask.next(v, end, true);
    }
    above_begin = row_begin;
    above_end = runs.size();
  }
  areas.assign(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    labels[i] = root(labels, static_cast<std::int32_t>(i));
    areas[index(labels[i])] += runs[i].end - runs[i].begin;
  }
}

Shape shape_of(RunSpan runs) {
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
  const auto squares = [](std::int64_t n) { return (n - 1) * n * (2 * n - 1) / 6; };  // 0 + 1 + 4 + ... + (n - 1)^2
  std::int64_t n = 0;
  std::int64_t sum_u = 0;
  std::int64_t sum_v = 0;
  std::int64_t sum_uu = 0;
  std::int64_t sum_uv = 0;
  std::int64_t sum_vv = 0;
  for (const PixelRun& run : runs) {
    const std::int64_t begin = run.begin - left;
    const std::int64_t end = run.end - left;
    const std::int64_t v = run.v - top;
    const std::int64_t count = end - begin;
    const std::int64_t sum = (begin + end - 1) * count / 2;
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

void BlobFinder::find(const BitMask& mask, const BlobParameters& parameters, BlobList& list) {
  labelled_.label(mask, parameters.connectivity);
  const std::vector<std::int64_t>& areas = labelled_.areas;
  list.blobs.clear();
  list.largest_area = 0;
  kept_.clear();
  for (std::size_t i = 0; i < areas.size(); ++i) {
    list.largest_area = std::max(list.largest_area, areas[i]);
    if (areas[i] > 0 && areas[i] >= parameters.min_area) kept_.push_back(i);
  }
  std::sort(kept_.begin(), kept_.end(),
            [&](std::size_t a, std::size_t b) { return areas[a] != areas[b] ? areas[a] > areas[b] : a < b; });
  if (kept_.size() > parameters.max_blobs) kept_.resize(parameters.max_blobs);

  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  rank_.assign(areas.size(), kNone);
  list.blobs.resize(kept_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    rank_[kept_[i]] = i;
    list.blobs[i].num_runs = 0;
  }
  const auto rank_of = [&](std::size_t run) { return rank_[index(labelled_.labels[run])]; };
  for (std::size_t i = 0; i < labelled_.runs.size(); ++i) {
    if (const std::size_t k = rank_of(i); k != kNone) ++list.blobs[k].num_runs;
  }
  std::size_t total = 0;
  for (Blob& blob : list.blobs) {
    blob.first_run = total;
    total += blob.num_runs;
    blob.num_runs = 0;
  }
  list.runs.resize(total);
  for (std::size_t i = 0; i < labelled_.runs.size(); ++i) {
    const std::size_t k = rank_of(i);
    if (k == kNone) continue;
    Blob& blob = list.blobs[k];
    list.runs[blob.first_run + blob.num_runs++] = labelled_.runs[i];
  }
  for (Blob& blob : list.blobs) blob.shape = shape_of(list.runs_of(blob));
}

BlobList find_blobs(const BitMask& mask, const BlobParameters& parameters) {
  BlobList list;
  BlobFinder().find(mask, parameters, list);
  return list;
}

void merge(const BlobList& list, std::vector<PixelRun>& runs) {
  runs = list.runs;
  std::sort(runs.begin(), runs.end(), before);
}

void HoleFiller::fill(RunSpan blob, std::int64_t max_hole, std::vector<PixelRun>& filled) {
  filled.assign(blob.begin(), blob.end());
  if (max_hole <= 0 || is_solid(blob)) return;
  // The blob's complement in its box and one pixel around: what is connected to that rim is outside.
  const Shape shape = shape_of(blob);
  const int left = shape.x - 1;
  const int top = shape.y - 1;
  background_.reset(shape.width + 2, shape.height + 2);
  std::size_t next = 0;
  for (int v = 0; v < background_.height(); ++v) {
    int begin = 0;
    for (; next < blob.size() && blob[next].v - top == v; ++next) {
      background_.set_run(v, begin, blob[next].begin - left);
      begin = blob[next].end - left;
    }
    background_.set_run(v, begin, background_.width());
  }
  labelled_.label(background_, Connectivity::kFour);
  for (std::size_t i = 0; i < labelled_.runs.size(); ++i) {
    const std::size_t region = index(labelled_.labels[i]);
    const PixelRun& run = labelled_.runs[i];
    // The rim is one region, and the very first: it holds the first run.
    if (region != 0 && labelled_.areas[region] <= max_hole) {
      filled.push_back({run.v + top, run.begin + left, run.end + left});
    }
  }
  if (filled.size() == blob.size()) return;
  std::sort(filled.begin(), filled.end(), before);
  runs_.clear();
  for (const PixelRun& run : filled) {
    if (!runs_.empty() && runs_.back().v == run.v && runs_.back().end == run.begin) {
      runs_.back().end = run.end;
    } else {
      runs_.push_back(run);
    }
  }
  filled.swap(runs_);
}

}  // namespace markservo::mark_detector
