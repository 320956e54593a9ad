#include "services/mark-detector/blobs/blobs.hpp"

#include <algorithm>
#include <limits>

namespace markservo::mark_detector {

void BlobFinder::find(const BitMask& mask, const BlobParameters& parameters, BlobList& list) {
  labelled_.label(mask, parameters.connectivity);
  choose(parameters, list);
  collect_runs(list);
  for (Blob& blob : list.blobs) blob.shape = shape_of(list.runs_of(blob));
}

// The regions that are kept, and as many blobs.
void BlobFinder::choose(const BlobParameters& parameters, BlobList& list) {
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
  list.blobs.resize(kept_.size());
}

void BlobFinder::collect_runs(BlobList& list) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  rank_.assign(labelled_.areas.size(), kNone);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    rank_[kept_[i]] = i;
    list.blobs[i].num_runs = 0;
  }
  const auto rank_of = [&](std::size_t run) { return rank_[labelled_.region_of(run)]; };
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

}  // namespace markservo::mark_detector
