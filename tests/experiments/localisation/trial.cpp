#include "tests/experiments/localisation/trial.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "common/geometry/plane_pose.hpp"
#include "services/simulator/random.hpp"
#include "tests/experiments/localisation/course.hpp"
#include "tests/experiments/localisation/described_reader.hpp"
#include "tests/experiments/localisation/described_wheels.hpp"
#include "tests/experiments/localisation/field_box.hpp"
#include "tests/experiments/localisation/fisher_bound.hpp"
#include "tests/experiments/localisation/gaussian_radius.hpp"
#include "tests/experiments/localisation/localizer_run.hpp"

namespace markservo::experiments {
namespace {

constexpr std::uint64_t kHeadingStream = 0xC2;
constexpr std::uint64_t kDelayStream = 0xC3;
constexpr double kStartHeadingSigma = geometry::radians(2.0);  // rad
constexpr double kLeastDelay = 0.13;                           // s, of those that a case draws
constexpr double kGreatestDelay = 0.25;                        // s
// s^2, of the uniform distribution that they are drawn from: the bound knows that, whatever the localizer is told.
constexpr double kDrawnDelayVariance = (kGreatestDelay - kLeastDelay) * (kGreatestDelay - kLeastDelay) / 12.0;
constexpr double kSameTime = 1e-7;     // s: times are whole microseconds
constexpr double kFieldMargin = 1e-3;  // m: one who starts on the field's edge is on the field

// The samples of a run that are scored.
struct Window {
  std::vector<double> times;  // s
  double settled_from = 0.0;  // s

  bool holds(double time) const { return time >= times.front() && time <= times.back(); }
};

class Trial {
 public:
  Trial(const LocalisationCase& the_case, const robot::RobotDescription& robot, const TrialFiles& files,
        std::int64_t seed)
      : case_(the_case),
        robot_(robot),
        files_(files),
        seed_(static_cast<std::uint64_t>(seed)),
        name_(the_case.name + "-" + std::to_string(seed)),
        box_(field_box(field())),
        plan_(plan_course(the_case, field(), seed_)),
        delay_(robot.rfid->delay) {
    simulator::BaseRigParameters rig = the_case.rig;
    rig.base = wheels_as_stated(*robot.base);
    rig.base.slip = the_case.rig.base.slip;
    if (the_case.delay_sigma) {
      simulator::RandomBits bits(simulator::seed_for(seed_, kDelayStream, 0));
      delay_ = kLeastDelay + (kGreatestDelay - kLeastDelay) * bits.uniform();
      told_.delay_sigma = the_case.delay_sigma;
      rig.reader.delay = delay_;
    }
    if (the_case.kind == CourseKind::kStraightStanding) {
      simulator::RandomBits bits(simulator::seed_for(seed_, kHeadingStream, 0));
      told_.start_heading = plan_.start.heading + kStartHeadingSigma * bits.gaussian();
      told_.start_heading_sigma = kStartHeadingSigma;
    }
    drive_ = drive(robot, rig, plan_, seed_);
  }

  TrialResult run() const {
    const TruePath path(drive_.truth);
    const Window window = scored(path);
    TrialResult result;
    result.seed = static_cast<std::int64_t>(seed_);
    const Localised ours = localised(true);
    const EncoderNoise noise = encoder_noise(wheels_as_stated(*robot_.base), robot_.base->track);
    const auto bound = live_bound(bound_input(window.times), path, noise);
    result.with_encoders = bounded(ours, bound, path, window);
    result.delay_error = ours.messages.back().delay - delay_;
    result.delay_error_bound = std::sqrt(bound.back()(3, 3));
    if (case_.without_encoders) result.without_encoders = free_score(path, window);
    const std::vector<PaperRead> reads = paper_reads(ours, robot_.rfid->p_RF);
    result.paper = score_paper(reads, path, robot_.rfid->p_RF, window.times.front(), window.times.back());
    if (files_.keep_logs) result.picture = picture(ours, reads, result.paper, window);
    return result;
  }

 private:
  const robot::TagField& field() const { return robot_.floor_tags->field(case_.rig.tag_field); }

  double first_read_arrival() const {
    for (const auto& round : drive_.rounds) {
      if (!round.hits.empty()) return seconds(round.utime);
    }
    throw std::runtime_error(name_ + ": no tag was read on the whole course");
  }

  Window scored(const TruePath& path) const {
    Window window;
    const double begin = std::max(first_read_arrival(), plan_.scored_from);
    window.settled_from = begin + case_.settling;
    for (const PathPoint& point : path.points()) {
      if (point.time < begin - kSameTime || point.time > plan_.scored_to + kSameTime) continue;
      if (box_.contains(point.at(robot_.rfid->p_RF), kFieldMargin)) window.times.push_back(point.time);
    }
    if (window.times.size() < 2 || window.times.back() < window.settled_from) {
      throw std::runtime_error(name_ + ": the course ends before anything has settled");
    }
    return window;
  }

  Localised localised(bool with_odometry) const {
    LocalizerRun run;
    run.robot_file = files_.robot_file;
    run.tag_field = field().name;
    run.files = (std::filesystem::path(files_.folder) / (name_ + (with_odometry ? "" : "-without-encoders"))).string();
    run.with_odometry = with_odometry;
    run.keep_files = files_.keep_logs;
    run.told = told_;
    return localise(drive_, run);
  }

  BoundInput bound_input(const std::vector<double>& times) const {
    const robot::RfidDescription& rfid = *robot_.rfid;
    BoundInput input;
    input.reader = described_reader(rfid, field());
    bool read = false;
    for (const auto& round : drive_.rounds) {
      read = read || !round.hits.empty();
      if (read) input.rounds.push_back({seconds(round.utime) - delay_, seconds(round.utime)});
    }
    input.times = times;
    input.prior.position_variance = box_.size().cwiseAbs2() / 12.0;
    input.prior.heading_variance = told_.start_heading ? kStartHeadingSigma * kStartHeadingSigma : M_PI * M_PI / 3.0;
    input.prior.delay_variance = case_.delay_sigma ? kDrawnDelayVariance : rfid.delay_sigma * rfid.delay_sigma;
    return input;
  }

  FreeScore free_score(const TruePath& path, const Window& window) const {
    const Localised free = localised(false);
    Window sent;
    sent.settled_from = window.settled_from;
    for (const PoseEstimate& pose : free.estimates) {
      if (window.holds(pose.time)) sent.times.push_back(pose.time);
    }
    const auto score = [&](const Window& samples) {
      return bounded(free, live_bound(bound_input(samples.times), path, FreeMotion{}), path, samples);
    };
    return {score(window), score(sent)};
  }

  static BoundedScore bounded(const Localised& localised, const std::vector<Eigen::Matrix4d>& bound,
                              const TruePath& path, const Window& window) {
    BoundedScore score;
    score.live = score_live(localised.estimates, path, window.times, window.settled_from);
    for (std::size_t i = 0; i < bound.size(); ++i) {
      const double mean = mean_radial_error(bound[i].topLeftCorner<2, 2>());
      score.bound_all.push_back(mean);
      if (window.times[i] < window.settled_from - kSameTime) continue;
      score.bound_settled.push_back(mean);
      const bool driving = std::abs(path.at(window.times[i]).speed) >= LiveScoreParameters{}.driving_speed;
      if (driving) score.bound_heading.push_back(std::sqrt(2.0 / M_PI * bound[i](2, 2)));
    }
    return score;
  }

  RunPicture picture(const Localised& ours, const std::vector<PaperRead>& reads, const std::vector<PaperError>& paper,
                     const Window& window) const {
    const auto scored = [&window](const auto& point) { return window.holds(point.time); };
    RunPicture result;
    for (const auto& tag : field().tags) result.tags.push_back(tag.p_W);
    result.paper = paper;
    std::copy_if(drive_.truth.begin(), drive_.truth.end(), std::back_inserter(result.truth), scored);
    std::copy_if(ours.estimates.begin(), ours.estimates.end(), std::back_inserter(result.estimates), scored);
    std::copy_if(reads.begin(), reads.end(), std::back_inserter(result.reads), scored);
    return result;
  }

  const LocalisationCase& case_;
  const robot::RobotDescription& robot_;
  const TrialFiles& files_;
  std::uint64_t seed_;
  std::string name_;
  FieldBox box_;
  CoursePlan plan_;
  double delay_;  // s, the true one
  Told told_;
  Drive drive_;
};

}  // namespace

TrialResult run_trial(const LocalisationCase& the_case, const robot::RobotDescription& robot, const TrialFiles& files,
                      std::int64_t seed) {
  return Trial(the_case, robot, files, seed).run();
}

}  // namespace markservo::experiments
