#include "tests/experiments/localisation/trial.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "services/simulator/random.hpp"
#include "tests/experiments/child_process.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/localisation/course.hpp"
#include "tests/experiments/localisation/fisher_bound.hpp"
#include "tests/experiments/localisation/gaussian_radius.hpp"
#include "tests/experiments/localisation/run_log.hpp"

namespace markservo::experiments {
namespace {

constexpr std::uint64_t kHeadingStream = 0xC2;
constexpr std::uint64_t kDelayStream = 0xC3;
constexpr double kStartHeadingSigma = 2.0 * M_PI / 180.0;  // rad
constexpr double kLeastDelay = 0.13;                       // s, of those that a case draws
constexpr double kGreatestDelay = 0.25;                    // s
constexpr double kSameTime = 1e-7;                         // s: times are whole microseconds
constexpr double kFieldMargin = 1e-3;                      // m: one who starts on the field's edge is on the field

// What the localizer is told besides robot.yaml.
struct Told {
  std::optional<double> start_heading;  // rad, to kStartHeadingSigma
  std::optional<double> scale_sigma;
  std::optional<double> delay_sigma;  // s
};

std::vector<std::string> words(const Told& told) {
  std::vector<std::string> result;
  const auto add = [&result](const std::string& option, double value) {
    result.push_back(option);
    result.push_back(std::to_string(value));
  };
  constexpr double kDegrees = 180.0 / M_PI;
  if (told.start_heading) {
    add("--start-heading", wrapped(*told.start_heading) * kDegrees);
    add("--start-heading-sigma", kStartHeadingSigma * kDegrees);
  }
  if (told.scale_sigma) add("--scale-sigma", *told.scale_sigma);
  if (told.delay_sigma) add("--delay-sigma", *told.delay_sigma);
  return result;
}

PoseEstimate estimate(const RobotPose& message) {
  PoseEstimate result;
  result.time = seconds(message.utime);
  result.p_WR = {message.pose.x, message.pose.y};
  result.heading = message.pose.heading;
  const auto& P = message.covariance;
  result.covariance << P.xx, P.xy, P.xh, P.xy, P.yy, P.yh, P.xh, P.yh, P.hh;
  result.speed = message.speed;
  result.turn_rate = message.turn_rate;
  result.localised = message.state == RobotPose::LOCALISED;
  return result;
}

struct Localised {
  std::vector<RobotPose> messages;
  std::vector<PoseEstimate> estimates;
};

// The scored part of a run.
struct Window {
  std::vector<double> times;  // s, of the truth's samples
  double settled_from = 0.0;  // s
};

class Trial {
 public:
  Trial(const LocalisationCase& the_case, const robot::RobotDescription& robot, const TrialFiles& files,
        std::int64_t seed)
      : case_(the_case),
        robot_(robot),
        files_(files),
        seed_(static_cast<std::uint64_t>(seed)),
        field_(robot.floor_tags->field(the_case.rig.tag_field)),
        plan_(plan_course(the_case, field_, seed_)),
        name_(the_case.name + "-" + std::to_string(seed)) {
    for (const auto& tag : field_.tags) tags_.push_back(tag.p_W);
    simulator::BaseRigParameters rig = the_case.rig;
    delay_ = robot.rfid->delay;
    if (the_case.delay_sigma) {
      simulator::RandomBits bits(simulator::seed_for(seed_, kDelayStream, 0));
      delay_ = kLeastDelay + (kGreatestDelay - kLeastDelay) * bits.uniform();
      told_.delay_sigma = the_case.delay_sigma;
      rig.reader.delay = delay_;
    }
    // Encoders of another quality are another robot, and its owner says so.
    if (rig.base.scale_sigma != simulator::BaseModelParameters{}.scale_sigma) told_.scale_sigma = rig.base.scale_sigma;
    if (the_case.kind == CourseKind::kStraightStanding) {
      simulator::RandomBits bits(simulator::seed_for(seed_, kHeadingStream, 0));
      told_.start_heading = plan_.start.heading + kStartHeadingSigma * bits.gaussian();
    }
    drive_ = drive(robot, rig, plan_, seed_);
  }

  TrialResult run() const {
    const TruePath path(drive_.truth);
    const Window window = scored(path);
    TrialResult result;
    const Localised ours = localise(true);
    const BoundInput input = bound_input(window);
    const EncoderNoise noise = encoder_noise();
    const auto bound = live_bound(input, path, noise);
    result.with_encoders = bounded(score_live(ours.estimates, path, window.times, window.settled_from), bound, window);
    result.delay_error = ours.messages.back().delay - delay_;
    result.delay_error_bound = std::sqrt(bound.back()(3, 3));
    if (case_.without_encoders) {
      const LiveScore live = score_live(localise(false).estimates, path, window.times, window.settled_from);
      result.without_encoders = bounded(live, live_bound(input, path, FreeMotion{}), window);
    }
    const std::vector<PaperRead> reads = paper_reads(ours);
    result.paper = score_paper(reads, path, robot_.rfid->p_RF, window.times.front(), window.times.back());
    if (files_.keep_logs) result.picture = picture(ours, reads, result.paper, window);
    return result;
  }

 private:
  double first_read_arrival() const {
    for (const auto& round : drive_.rounds) {
      if (!round.hits.empty()) return seconds(round.utime);
    }
    throw std::runtime_error(name_ + ": no tag was read on the whole course");
  }

  bool over_field(const PathPoint& truth) const {
    Eigen::Vector2d least = tags_.front();
    Eigen::Vector2d greatest = tags_.front();
    for (const auto& tag : tags_) {
      least = least.cwiseMin(tag);
      greatest = greatest.cwiseMax(tag);
    }
    const Eigen::Vector2d p_WF = truth.at(robot_.rfid->p_RF);
    return (p_WF.array() >= least.array() - kFieldMargin).all() &&
           (p_WF.array() <= greatest.array() + kFieldMargin).all();
  }

  Window scored(const TruePath& path) const {
    Window window;
    const double begin = std::max(first_read_arrival(), plan_.scored_from);
    window.settled_from = begin + case_.settling;
    for (const PathPoint& point : path.points()) {
      if (point.time < begin - kSameTime || point.time > plan_.scored_to + kSameTime) continue;
      if (over_field(point)) window.times.push_back(point.time);
    }
    if (window.times.size() < 2 || window.times.back() < window.settled_from) {
      throw std::runtime_error(name_ + ": the course ends before the first second after the first read");
    }
    return window;
  }

  Localised localise(bool with_odometry) const {
    const std::string base =
        (std::filesystem::path(files_.folder) / (name_ + (with_odometry ? "" : "-without-encoders"))).string();
    const std::string in = base + ".lcm";
    const std::string out = base + "-poses.lcm";
    const std::string log = base + ".log";
    std::filesystem::remove(out);
    write_log(drive_, with_odometry, in);
    std::vector<std::string> command{sibling_executable("rfid-localizer"),
                                     "--robot-file",
                                     files_.robot_file,
                                     "--tag-field",
                                     field_.name,
                                     "--lcm-in",
                                     "file://" + in + "?speed=0",
                                     "--lcm-out",
                                     "file://" + out + "?mode=w"};
    const auto more = words(told_);
    command.insert(command.end(), more.begin(), more.end());
    const int code = ChildProcess(command, log).wait();
    if (code != 0)
      throw std::runtime_error("rfid-localizer ended with exit code " + std::to_string(code) + ", see " + log);
    Localised result;
    result.messages = read_poses(out);
    if (result.messages.empty()) throw std::runtime_error(out + ": holds no ROBOT_POSE");
    for (const auto& message : result.messages) result.estimates.push_back(estimate(message));
    if (!files_.keep_logs) {
      for (const auto& file : {in, out, log}) std::filesystem::remove(file);
    }
    return result;
  }

  BoundInput bound_input(const Window& window) const {
    BoundInput input;
    const auto& rfid = *robot_.rfid;
    input.reader = {rfid.p_RF, rfid.reading_radius, rfid.edge_softness, rfid.read_probability, rfid.round_time, tags_};
    bool read = false;
    for (const auto& round : drive_.rounds) {
      read = read || !round.hits.empty();
      if (read) input.rounds.push_back({seconds(round.utime) - delay_, seconds(round.utime)});
    }
    input.times = window.times;
    Eigen::Vector2d least = tags_.front();
    Eigen::Vector2d greatest = tags_.front();
    for (const auto& tag : tags_) {
      least = least.cwiseMin(tag);
      greatest = greatest.cwiseMax(tag);
    }
    input.prior.position_variance = (greatest - least).cwiseAbs2() / 12.0;
    input.prior.heading_variance = told_.start_heading ? kStartHeadingSigma * kStartHeadingSigma : M_PI * M_PI / 3.0;
    input.prior.delay_variance = std::pow(told_.delay_sigma.value_or(rfid.delay_sigma), 2);
    return input;
  }

  EncoderNoise encoder_noise() const {
    EncoderNoise noise;
    noise.scale_sigma = case_.rig.base.scale_sigma;
    noise.heading_drift = case_.rig.base.drift;
    noise.along = 0.5 * case_.rig.base.drift * robot_.base->track;
    return noise;
  }

  static BoundedScore bounded(const LiveScore& live, const std::vector<Eigen::Matrix4d>& bound, const Window& window) {
    BoundedScore score;
    score.live = live;
    for (std::size_t i = 0; i < bound.size(); ++i) {
      const double mean = mean_radial_error(bound[i].topLeftCorner<2, 2>());
      score.bound_all.push_back(mean);
      if (window.times[i] >= window.settled_from - kSameTime) score.bound_settled.push_back(mean);
    }
    return score;
  }

  std::vector<PaperRead> paper_reads(const Localised& ours) const {
    std::vector<PaperRead> reads;
    std::int64_t last = 0;
    for (const auto& message : ours.messages) {
      const PaperLocalisation& paper = message.paper;
      if (paper.measured_known == 0 || paper.utime == last) continue;
      last = paper.utime;
      const double time = seconds(paper.utime);
      const PoseEstimate* fused = newest(ours.estimates, time);
      if (fused == nullptr) continue;
      const PoseEstimate at_read = moved_on(*fused, time);
      PathPoint robot;
      robot.p_WR = at_read.p_WR;
      robot.heading = at_read.heading;
      reads.push_back({time,
                       {paper.measured_x, paper.measured_y},
                       {paper.compensated_x, paper.compensated_y},
                       robot.at(robot_.rfid->p_RF)});
    }
    return reads;
  }

  RunPicture picture(const Localised& ours, const std::vector<PaperRead>& reads, const std::vector<PaperError>& paper,
                     const Window& window) const {
    const auto in_window = [&window](double time) {
      return time >= window.times.front() && time <= window.times.back();
    };
    RunPicture result;
    result.tags = tags_;
    result.paper = paper;
    std::copy_if(drive_.truth.begin(), drive_.truth.end(), std::back_inserter(result.truth),
                 [&](const auto& point) { return in_window(point.time); });
    std::copy_if(ours.estimates.begin(), ours.estimates.end(), std::back_inserter(result.estimates),
                 [&](const auto& pose) { return in_window(pose.time); });
    std::copy_if(reads.begin(), reads.end(), std::back_inserter(result.reads),
                 [&](const auto& read) { return in_window(read.time); });
    return result;
  }

  const LocalisationCase& case_;
  const robot::RobotDescription& robot_;
  const TrialFiles& files_;
  std::uint64_t seed_;
  const robot::TagField& field_;
  CoursePlan plan_;
  std::string name_;
  std::vector<Eigen::Vector2d> tags_;
  Told told_;
  double delay_ = 0.0;  // s, the true one
  Drive drive_;
};

}  // namespace

TrialResult run_trial(const LocalisationCase& the_case, const robot::RobotDescription& robot, const TrialFiles& files,
                      std::int64_t seed) {
  return Trial(the_case, robot, files, seed).run();
}

}  // namespace markservo::experiments
