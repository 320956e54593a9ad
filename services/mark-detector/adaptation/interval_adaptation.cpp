#include "services/mark-detector/adaptation/interval_adaptation.hpp"

#include <algorithm>
#include <cstddef>

namespace markservo::mark_detector {
namespace {

constexpr double kUsualSpread = 0.3;  // of a printed mark's brightness, until it is measured
// Brightness of a print, in standard deviations from its mean.
constexpr std::array<double, 5> kBrightness = {-1.7, -0.85, 0.0, 0.85, 1.7};

double middle_of(const NominalColour& nominal) {
  return 0.5 * (nominal.low + nominal.high);
}

// What the camera shows of a print, from its darkest to its brightest.
struct ShownColour {
  double low = kFullTurn_deg;  // degrees from the nominal middle
  double high = -kFullTurn_deg;
  double pale = 1.0;  // saturation, less twice the noise
  double pure = 0.0;  // likewise, more
  double dark = 1.0;  // value
  double bright = 0.0;
  double noise_turn = 0.0;  // degrees, twice the noise's

  bool nothing() const { return low > high; }  // black or white throughout: no interval takes it in
};

ShownColour shown_colour(const NominalColour& nominal, const MarkColour& mark, const Bgr& light, int chroma_min,
                         double noise_levels) {
  Bgr mean = mark.mean;
  if (!mark.known) {
    for (std::size_t c = 0; c < 3; ++c) mean[c] = nominal.colour[c] * light[c];
  }
  const double spread = mark.known ? mark.spread : kUsualSpread;
  ShownColour shown;
  for (const double deviations : kBrightness) {
    Bgr colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = std::min(kWhiteLevel, mean[c] * std::max(0.2, 1.0 + deviations * spread));
    }
    const Hsv hsv = hsv_of(colour);
    if (hsv.chroma < chroma_min || hsv.value < kDarkLevel) continue;
    const double turn = signed_angle(hsv.hue_deg - middle_of(nominal));
    shown.low = std::min(shown.low, turn);
    shown.high = std::max(shown.high, turn);
    const double noise = noise_levels / hsv.value;
    shown.pale = std::min(shown.pale, hsv.saturation - 2.0 * noise);
    shown.pure = std::max(shown.pure, hsv.saturation + 2.0 * noise);
    shown.dark = std::min(shown.dark, hsv.value / kWhiteLevel);
    shown.bright = std::max(shown.bright, hsv.value / kWhiteLevel);
    if (deviations == 0.0) shown.noise_turn = 2.0 * 60.0 * noise_levels / hsv.chroma;
  }
  return shown;
}

// Each end follows the other as far as the colour allows; where the prediction may be wrong, the nominal hues stay in.
HueRange turned(const NominalColour& nominal, const ShownColour& shown, bool sure,
                const IntervalParameters& parameters) {
  const double middle = middle_of(nominal);
  const double half_width = 0.5 * (nominal.high - nominal.low);
  const double margin = std::min(parameters.hue_margin_deg + shown.noise_turn, parameters.hue_margin_max_deg);
  const double furthest = half_width + parameters.turn_max_deg;
  HueRange range;
  range.needed_low = middle + std::clamp(shown.low, -furthest, furthest);
  range.needed_high = middle + std::clamp(shown.high, -furthest, furthest);
  const double least = std::max(shown.low - margin, -furthest);
  const double greatest = std::min(shown.high + margin, furthest);
  const double down = std::max(0.0, -half_width - least);
  const double up = std::max(0.0, greatest - half_width);
  range.low = middle + (sure ? std::min(std::max(-half_width, least), -half_width + up) : -half_width) - down;
  range.high = middle + (sure ? std::max(std::min(half_width, greatest), half_width - down) : half_width) + up;
  return range;
}

void relax_saturation(const NominalColour& nominal, const ShownColour& shown, bool sure, const Bgr& light,
                      const IntervalParameters& parameters, robot::ColourInterval& interval) {
  interval.saturation_min = std::min(
      interval.saturation_min,
      std::max(parameters.saturation_share * interval.saturation_min, shown.pale - parameters.saturation_margin));
  if (sure) {
    // A cast gives muted things of its hue more saturation: what was too pale for the mark remains too pale.
    Bgr palest = bgr_of(middle_of(nominal), nominal.interval.saturation_min, 1.0);
    for (std::size_t c = 0; c < 3; ++c) palest[c] *= light[c];
    const double raised = std::min(hsv_of(palest).saturation, shown.pale - 2.0 * parameters.saturation_margin);
    interval.saturation_min = std::max(interval.saturation_min, raised);
  }
  interval.saturation_max = std::max(interval.saturation_max, std::min(1.0, shown.pure + parameters.saturation_margin));
}

// Equalisation only brightens, so what passes as photographed passes.
void relax_value(const ShownColour& shown, bool known, const Bgr& light, double share,
                 robot::ColourInterval& interval) {
  // Of a mark not seen yet the print's darkest is not known, but how much darker it became.
  const double least_value =
      known ? share * shown.dark : interval.value_min * *std::min_element(light.begin(), light.end());
  interval.value_min = std::min(interval.value_min, least_value);
  interval.value_max = std::max(interval.value_max, std::min(1.0, shown.bright / share));
}

}  // namespace

HueRange adapt_interval(const NominalColour& nominal, const MarkColour& mark, const Bgr& light, int chroma_min,
                        const IntervalParameters& parameters, robot::ColourInterval& interval) {
  interval = nominal.interval;
  const ShownColour shown = shown_colour(nominal, mark, light, chroma_min, parameters.noise);
  if (shown.nothing()) return {middle_of(nominal), middle_of(nominal), nominal.low, nominal.high};
  const HueRange range = turned(nominal, shown, mark.sure(), parameters);
  if (nominal.shares_hue) return range;
  relax_saturation(nominal, shown, mark.sure(), light, parameters, interval);
  relax_value(shown, mark.known, light, parameters.value_share, interval);
  return range;
}

void keep_apart(const std::vector<NominalColour>& nominal, double gap_deg, HueRanges& ranges) {
  const HueRanges alone = ranges;
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    for (std::size_t j = 0; j < nominal.size(); ++j) {
      if (i == j || nominal[i].fixed || nominal[j].fixed) continue;
      HueRange& below = ranges[i];
      HueRange& above = ranges[j];
      const double nominal_gap = hue_gap(nominal[i].low, nominal[i].high, nominal[j].low, nominal[j].high);
      // From the hues of `below` to those of `above`, which may be a turn further on.
      const double turns = nominal[i].high + nominal_gap - nominal[j].low;
      if (nominal_gap < gap_deg) {
        below.high = std::min(below.high, nominal[i].high);
        above.low = std::max(above.low, nominal[j].low);
        continue;
      }
      const HueRange& a = alone[i];
      const HueRange& b = alone[j];
      if (b.low + turns - a.high >= gap_deg) continue;
      const double between_needed = b.needed_low + turns - a.needed_high;
      const bool told_apart = between_needed >= gap_deg;
      const double border = told_apart ? a.needed_high + 0.5 * between_needed : nominal[i].high + 0.5 * nominal_gap;
      below.high = std::min(below.high, border - 0.5 * gap_deg);
      above.low = std::max(above.low, border - turns + 0.5 * gap_deg);
    }
  }
}

}  // namespace markservo::mark_detector
