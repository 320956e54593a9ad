#include "tests/experiments/localisation/cases.hpp"

#include <cmath>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::experiments {
namespace {

constexpr double kBoundRatio = 1.3;
constexpr double kHeadingBar = geometry::radians(2.0);  // rad
constexpr int kStressTrials = 2;                        // times the others': divergence is rare where it happens at all
constexpr double kStressRatio = 1.5;
constexpr double kMostNotLocalised = 0.02;  // NEES judges the other samples only

LocalisationCase on_course(const std::string& name, CourseKind kind, const std::string& course,
                           const std::string& variant) {
  LocalisationCase result;
  result.name = name;
  result.course = course;
  result.variant = variant;
  result.kind = kind;
  const bool field = kind == CourseKind::kStraight || kind == CourseKind::kStraightStanding ||
                     kind == CourseKind::kDiagonal || kind == CourseKind::kStatic;
  result.rig.tag_field = field ? "course" : "hall";
  result.bars.bound_ratio = kBoundRatio;
  if (kind != CourseKind::kStatic) result.bars.heading_mean = kHeadingBar;
  result.bars.nees = true;
  result.bars.not_localised_share = kMostNotLocalised;
  result.bars.must_not_diverge = true;
  return result;
}

LocalisationCase hall(const std::string& name, const std::string& variant, std::optional<double> bar) {
  LocalisationCase result = on_course(name, CourseKind::kHall, "hall", variant);
  result.bars.settled_mean = bar;
  return result;
}

// Fewer reads: the heading takes longer than a second, and 15 cm are no divergence where tags are farther apart.
LocalisationCase sparse_hall(const std::string& name, const std::string& variant, double spacing,
                             std::optional<double> bar) {
  LocalisationCase result = hall(name, variant, bar);
  result.robot.spacing = spacing;
  result.bars.heading_mean.reset();
  result.bars.must_not_diverge = false;
  result.bars.not_localised_share.reset();
  return result;
}

// A fault that neither the localizer nor the bound is told of.
LocalisationCase stress(const std::string& name, const std::string& variant) {
  LocalisationCase result = hall(name, variant, std::nullopt);
  result.trials_factor = kStressTrials;
  result.bars = CaseBars{};
  result.bars.hall_ratio = kStressRatio;
  result.bars.must_not_diverge = true;
  result.bars.not_localised_share = kMostNotLocalised;
  return result;
}

void add_field_courses(std::vector<LocalisationCase>& cases) {
  LocalisationCase straight = on_course("straight", CourseKind::kStraight, "straight", "plain");
  straight.without_encoders = true;
  straight.bars.settled_mean = 0.017;
  straight.bars.free_mean = 0.021;
  straight.bars.paper_gain_axis = 0.65;
  cases.push_back(straight);

  LocalisationCase standing =
      on_course("straight_standing", CourseKind::kStraightStanding, "straight", "2 s standing, heading to 2 deg");
  standing.without_encoders = true;
  standing.bars.all_mean = 0.012;
  cases.push_back(standing);

  LocalisationCase diagonal = on_course("diagonal", CourseKind::kDiagonal, "diagonal", "plain");
  diagonal.without_encoders = true;
  diagonal.bars.paper_gain_axis = 0.50;
  // Less than half a second of it is left when the heading has had its first one: the bound itself is 2.2 degrees.
  diagonal.bars.heading_mean.reset();
  cases.push_back(diagonal);

  LocalisationCase still = on_course("static", CourseKind::kStatic, "static", "after 5 s");
  still.without_encoders = true;
  still.speed = 0.0;
  still.settling = 5.0;
  still.bars.settled_mean = 0.005;
  cases.push_back(still);
}

void add_hall_courses(std::vector<LocalisationCase>& cases) {
  cases.push_back(hall("hall", "plain", 0.013));
  cases.back().without_encoders = true;
  cases.push_back(on_course("circle", CourseKind::kCircle, "circle", "plain"));

  LocalisationCase stop_and_go =
      on_course("stop_and_go", CourseKind::kStopAndGo, "stop_and_go", "delay 130 to 250 ms, told 190");
  stop_and_go.without_encoders = true;
  stop_and_go.delay_sigma = 0.04;
  stop_and_go.bars.delay_error = 0.012;
  cases.push_back(stop_and_go);

  // Encoders four times as good in both ways that they err.
  const auto give_good_encoders = [](LocalisationCase& the_case) {
    the_case.robot.scale_sigma = 0.005;
    the_case.robot.drift_deg = 0.5;
  };
  LocalisationCase good = hall("hall_odometry_0.5pct", "odometry 0.5%, 0.5 deg/sqrt(m)", 0.011);
  give_good_encoders(good);
  cases.push_back(good);
  LocalisationCase quick = hall("hall_20Hz_0.5pct", "20 Hz, odometry 0.5%, 0.5 deg/sqrt(m)", 0.008);
  give_good_encoders(quick);
  quick.robot.round_time = 0.05;
  cases.push_back(quick);
  // With the better scale alone the bound itself is 0.81 cm at 20 Hz: no bar.
  good = hall("hall_scale_0.5pct", "scale 0.5%, 2 deg/sqrt(m)", 0.011);
  good.robot.scale_sigma = 0.005;
  cases.push_back(good);
  quick = hall("hall_20Hz_scale_0.5pct", "20 Hz, scale 0.5%, 2 deg/sqrt(m)", std::nullopt);
  quick.robot.scale_sigma = 0.005;
  quick.robot.round_time = 0.05;
  cases.push_back(quick);
  LocalisationCase dense = hall("hall_d5", "d 5 cm", 0.008);
  dense.robot.spacing = 0.05;
  cases.push_back(dense);
  LocalisationCase dense_good = dense;
  dense_good.name = "hall_d5_0.5pct";
  dense_good.variant = "d 5 cm, odometry 0.5%, 0.5 deg/sqrt(m)";
  give_good_encoders(dense_good);
  cases.push_back(dense_good);

  // With the footprint of the others, and with one that suits the spacing, which is what the bars are for.
  cases.push_back(sparse_hall("hall_d20", "d 20 cm, r 10 cm", 0.20, std::nullopt));
  cases.push_back(sparse_hall("hall_d20_r15", "d 20 cm, r 15 cm", 0.20, 0.021));
  cases.back().robot.reading_radius = 0.15;
  cases.push_back(sparse_hall("hall_d34", "d 34 cm, r 10 cm", 0.34, std::nullopt));
  // Tags read one at a time, 14 cm apart at best, leave several places possible: no covariance describes that, nor
  // does a bound made of covariances.
  cases.back().bars = CaseBars{};
  cases.push_back(sparse_hall("hall_d34_r20", "d 34 cm, r 20 cm, s 2 cm", 0.34, 0.040));
  cases.back().robot.reading_radius = 0.20;
  cases.back().robot.edge_softness = 0.02;

  LocalisationCase fast = hall("hall_100cm_s", "100 cm/s", 0.022);
  fast.speed = 1.0;
  cases.push_back(fast);
}

void add_stresses(std::vector<LocalisationCase>& cases) {
  LocalisationCase missed = stress("stress_missed", "20% of reads missed");
  missed.rig.reader.missed = 0.20;
  cases.push_back(missed);
  LocalisationCase missing = stress("stress_missing", "5% of tags missing");
  missing.rig.floor.missing = 0.05;
  cases.push_back(missing);
  LocalisationCase map = stress("stress_map", "tags 1 cm off the map");
  map.rig.floor.survey_error = 0.01;
  cases.push_back(map);
  LocalisationCase slip = stress("stress_slip", "5% wheel slip");
  slip.rig.base.slip = 0.05;
  cases.push_back(slip);
}

}  // namespace

std::vector<LocalisationCase> localisation_cases() {
  std::vector<LocalisationCase> cases;
  add_field_courses(cases);
  add_hall_courses(cases);
  add_stresses(cases);
  return cases;
}

LocalisationCase find_case(const std::string& name) {
  std::string names;
  for (const LocalisationCase& candidate : localisation_cases()) {
    if (candidate.name == name) return candidate;
    names += (names.empty() ? "" : ", ") + candidate.name;
  }
  throw ConfigurationError("--case: there is no case '" + name + "'; allowed: " + names);
}

}  // namespace markservo::experiments
