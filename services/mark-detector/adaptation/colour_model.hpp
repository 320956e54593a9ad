#pragma once

// Marks' colours under the light of the moment.
//
// Light changes by a gain and a cast, that is by one gain a channel (von Kries). Each mark's colour is predicted from
// frame to frame by the gains that the whole image shows (light_change.hpp), and drawn to what its pixels measure
// whenever both images see it and agree. From it follows the interval in use: the nominal one, turned and relaxed by no
// more than is needed for the mark's colour, over the range of its print's brightness and clipped at 255 as the camera
// clips it, to lie well inside. A colour that lies well inside the nominal interval leaves it as it is.

#include <array>
#include <cstddef>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/adaptation/light_change.hpp"
#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/colour/colour_classifier.hpp"
#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct ColourModelParameters {
  LightChangeParameters light;
  double noise = 3.0;           // levels, sigma of the camera's noise
  double hue_margin_deg = 8.0;  // how far inside its interval a colour must lie, besides twice the noise's turn
  double hue_margin_max_deg = 20.0;
  double saturation_margin = 0.08;    // likewise, besides twice the noise
  double saturation_share = 0.5;      // of the nominal least saturation: below it, pale things of the same hue come in
  double value_share = 0.8;           // of the darkest print's value that still passes
  double turn_max_deg = 35.0;         // past an end of the nominal interval: blue that clips turns by 30 degrees
  double gap_deg = 4.0;               // kept between two marks' intervals
  double hue_jump_max_deg = 12.0;     // from a sure prediction: further off is a thing of a similar colour
  double saturation_jump_max = 0.15;  // likewise; the two make an ellipse
  double smoothing = 0.4;             // share of a new measurement; the prediction brings sudden changes
  int memory_frames = 300;            // for which the colour of a mark that is not seen is predicted: 10 s at 30 Hz
  int samples_per_side = 16;          // rows and columns looked at of the window around a mark
  int least_samples = 12;             // unclipped pixels that make a measurement
};

// What is known of one mark's colour.
struct MarkColour {
  bool known = false;    // seen within the memory
  int age = 0;           // frames since it was seen
  bool certain = false;  // the light's change could be told in all of them
  Bgr mean{};            // levels as the camera would show them if it did not clip
  double spread = 0.0;   // standard deviation of the print's brightness, share of the mean
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
  struct Nominal {
    robot::ColourInterval interval;
    double low = 0.0;   // degrees, [0, 360)
    double high = 0.0;  // degrees, above low
    bool fixed = false;
    bool shares_hue = false;  // with another mark: told apart by saturation or value, which then stay
    Bgr colour{};             // levels, in the middle
  };
  // Hues that a mark needs, and those in use: degrees, unwrapped, about its nominal interval.
  struct Range {
    double needed_low = 0.0;
    double needed_high = 0.0;
    double low = 0.0;
    double high = 0.0;
  };

  void predict(const LightChange& change, ColourState& state) const;
  Range adapt(const Nominal& nominal, const MarkColour& mark, const Bgr& light, robot::ColourInterval& interval) const;
  using Ranges = std::array<Range, robot::kMaxMarks>;
  void keep_apart(Ranges& ranges) const;

  ColourModelParameters parameters_;
  int chroma_min_;
  std::vector<Nominal> nominal_;
};

}  // namespace markservo::mark_detector
