#pragma once

// The paper's localisation (section 4): Gaussian-weighted average of the tags read, direction of motion by Hough
// transform over the recent averages, compensation of the delay along it. It knows nothing but the reads and a speed.

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace markservo::rfid_localizer {

struct PaperParameters {
  double weight_sigma = 0.07;        // m, of the Gaussian weight: a tag at the footprint's edge (10 cm) counts a third
  int recent = 15;                   // averages that vote for the direction
  int least_recent = 3;              // fewer give none
  double least_way = 0.05;           // m between the first and the last of them: less is noise, not motion
  double delay = 0.19;               // s, from reading to the answer
  double angle_step = 0.0174532925;  // rad, of the Hough accumulator: 1 degree
  double line_width = 0.06;          // m, of its distance bins: twice the averages' own error
};

struct PaperEstimate {
  std::int64_t utime = 0;                                 // us, of the round's answer
  Eigen::Vector2d measured = Eigen::Vector2d::Zero();     // m in W
  std::optional<double> direction;                        // rad in W
  double speed = 0.0;                                     // m/s
  double delay = 0.0;                                     // s
  Eigen::Vector2d compensated = Eigen::Vector2d::Zero();  // m in W
};

// Weighted average of the positions (m): Gaussian weights of the distance from their plain mean. `tags` not empty.
Eigen::Vector2d weighted_average(const std::vector<Eigen::Vector2d>& tags, double weight_sigma);

// Direction (rad) of the line on which most of `points` (m, oldest first) lie, pointing the way they went; nothing for
// fewer points or less way than the parameters ask for.
std::optional<double> hough_direction(const std::deque<Eigen::Vector2d>& points, const PaperParameters& parameters);

class PaperMethod {
 public:
  explicit PaperMethod(const PaperParameters& parameters) : parameters_(parameters) {}

  // A round's answer at `utime` (us) with the positions (m) of the tags read. `speed` in m/s; nothing: told from the
  // averages' own way. Nothing when no tag was read.
  std::optional<PaperEstimate> observe(std::int64_t utime, const std::vector<Eigen::Vector2d>& tags,
                                       const std::optional<double>& speed);
  // Of the newest round that read a tag.
  const std::optional<PaperEstimate>& newest() const { return newest_; }
  void forget();

 private:
  double own_speed() const;

  PaperParameters parameters_;
  std::deque<Eigen::Vector2d> averages_;
  std::deque<std::int64_t> times_;
  std::optional<PaperEstimate> newest_;
};

}  // namespace markservo::rfid_localizer
