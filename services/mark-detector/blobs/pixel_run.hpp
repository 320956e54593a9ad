#pragma once

// Pixels that lie side by side in a row.

#include <cstddef>
#include <vector>

namespace markservo::mark_detector {

// Pixels [begin, end) of row v.
struct PixelRun {
  int v = 0;
  int begin = 0;
  int end = 0;
};

// Whether `a` comes before `b` in the order of rows, then of columns.
inline bool before(const PixelRun& a, const PixelRun& b) {
  return a.v != b.v ? a.v < b.v : a.begin < b.begin;
}

// Runs that belong to somebody else.
class RunSpan {
 public:
  RunSpan() = default;
  RunSpan(const PixelRun* first, std::size_t count) : first_(first), count_(count) {}
  RunSpan(const std::vector<PixelRun>& runs) : RunSpan(runs.data(), runs.size()) {}  // NOLINT: as good as the runs

  const PixelRun* begin() const { return first_; }
  const PixelRun* end() const { return first_ + count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const PixelRun& front() const { return *first_; }
  const PixelRun& operator[](std::size_t i) const { return first_[i]; }

 private:
  const PixelRun* first_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace markservo::mark_detector
