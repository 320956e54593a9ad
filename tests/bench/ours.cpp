#include "tests/bench/ours.hpp"

#include <algorithm>

#include "services/mark-detector/colour/colour_kernel.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"
#include "tests/scenes/observation.hpp"

namespace markservo::bench {
namespace {

using scenes::view_of;

mark_detector::Parameters parameters_for(Scan scan) {
  mark_detector::Parameters parameters;
  switch (scan) {
    case Scan::kWholeImage:
      parameters.search.full_scan_every = 1;
      break;
    case Scan::kTracked:
      break;
  }
  return parameters;
}

}  // namespace

Ours::Ours(const std::vector<robot::MarkDescription>& marks, const geometry::StereoCamera& camera, Scan scan)
    : marks_(marks), camera_(camera), parameters_(parameters_for(scan)), detector_(marks, parameters_) {
  for (const robot::MarkDescription& mark : marks) {
    rules_.push_back(mark_detector::make_rule(mark.colour, parameters_.chroma_min));
  }
}

Ours::Result Ours::run(const scenes::StereoPair& pair) {
  const mark_detector::Output& detection = detect(pair);
  return {detection, locate(detection)};
}

const mark_detector::Output& Ours::detect(const scenes::StereoPair& pair) {
  mark_detector::Input input;
  input.left = view_of(pair.left);
  input.right = view_of(pair.right);
  input.stereo = camera_;
  return detector_.step(input, state_);
}

std::vector<target_locator::Location> Ours::locate(const mark_detector::Output& detection) {
  std::vector<target_locator::Location> locations;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const target_locator::MarkObservation observation = scenes::observation_of(detection.marks[i], marks_[i]);
    locations.push_back(target_locator::locate_mark(observation, camera_, locator_, work_));
  }
  return locations;
}

mark_detector::LumaShift Ours::equalise(const scenes::StereoPair& pair) const {
  return mark_detector::against_darkness(
      mark_detector::equalising_shift(view_of(pair.left), view_of(pair.right), parameters_.histogram_rows));
}

void Ours::classify(const scenes::StereoPair& pair, const mark_detector::LumaShift& shift) {
  mark_detector::frame_rules(rules_, shift, frame_rules_);
  for (const auto& [image, masks] :
       {std::pair(view_of(pair.left), &left_masks_), std::pair(view_of(pair.right), &right_masks_)}) {
    mark_detector::ScanRules rules;
    masks->resize(rules_.size());
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      (*masks)[i].reset(image.width, image.height);
      rules.add(frame_rules_[i], (*masks)[i]);
    }
    mark_detector::scan(image, mark_detector::whole_image(image), shift, rules);
  }
}

std::size_t Ours::label() {
  mark_detector::BlobParameters parameters;
  parameters.min_area = parameters_.views.min_area;
  std::size_t count = 0;
  for (const auto* const masks : {&left_masks_, &right_masks_}) {
    for (const imaging::BitMask& mask : *masks) {
      filter_.apply(mask, clean_);
      finder_.find(clean_, parameters, blobs_);
      count += blobs_.blobs.size();
    }
  }
  return count;
}

}  // namespace markservo::bench
