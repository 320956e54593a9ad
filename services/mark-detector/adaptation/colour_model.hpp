#pragma once

// Marks' colours under the light of the moment.
//
// Light changes by a gain and a cast, that is by one gain a channel (von Kries). Each mark's colour is predicted from
// frame to frame by the gains that the whole image shows (light_change.hpp), and drawn to what its pixels measure
// (colour_measurement.hpp) whenever both images see it and agree. From it follows the interval in use
// (interval_adaptation.hpp). A colour that lies well inside the nominal interval leaves it as it is.

#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/adaptation/colour_measurement.hpp"
#include "services/mark-detector/adaptation/interval_adaptation.hpp"
#include "services/mark-detector/adaptation/light_change.hpp"
#include "services/mark-detector/adaptation/mark_colour.hpp"
#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/colour/colour_classifier.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct ColourModelParameters {
  LightChangeParameters light;
  ColourMeasurementParameters measurement;
  IntervalParameters interval;
  double hue_jump_max_deg = 12.0;     // from a sure prediction: further off is a thing of a similar colour
  double saturation_jump_max = 0.15;  // likewise; the two make an ellipse
  double smoothing = 0.4;             // share of a new measurement; the prediction brings sudden changes
  int memory_frames = 300;            // for which the colour of a mark that is not seen is predicted: 10 s at 30 Hz
};

// Memory from frame to frame; its room is used again.
struct ColourState {
  LightSamples samples;
  Bgr light{1.0, 1.0, 1.0};                      // gains since the beginning, forgotten with the memory
  std::vector<MarkColour> marks;                 // as configured
  std::vector<robot::ColourInterval> intervals;  // in use
  std::vector<ColourRule> rules;                 // likewise
};

class ColourModel {
 public:
  // Colours as in robot.yaml. An interval of every hue is never adapted. `chroma_min`: make_rule. Throws
  // std::invalid_argument if parameters are out of range.
  ColourModel(const std::vector<robot::MarkDescription>& marks, int chroma_min,
              const ColourModelParameters& parameters = {});

  // Call first for each frame: the rules to classify it with, one a mark, in their order; valid until the next call.
  const std::vector<ColourRule>& rules(const ImageView& image, ColourState& state) const;

  // Call for each mark that both images of the frame saw alike: measures its colour in both. False if it does
  // not show the colour that the mark is known to have in this light; then nothing is learned from it.
  bool observe(std::size_t mark, const ImageView& left, const Region& in_left, const ImageView& right,
               const Region& in_right, ColourState& state) const;

 private:
  void predict(const LightChange& change, ColourState& state) const;
  bool jumps(const MarkColour& predicted, const ColourMeasurement& measured) const;

  ColourModelParameters parameters_;
  int chroma_min_;
  std::vector<NominalColour> nominal_;
};

}  // namespace markservo::mark_detector
