#include "services/mark-detector/blobs/labelled_runs.hpp"

#include <algorithm>

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

}  // namespace markservo::mark_detector
