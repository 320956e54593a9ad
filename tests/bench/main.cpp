// scripts/bench: how long our chain from an image pair to the marks' places takes, beside other ways to do it, on the
// same images in the same run; and whether the answers agree.

#include <CLI/CLI.hpp>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/bench/accuracy.hpp"
#include "tests/bench/bench_marks.hpp"
#include "tests/bench/report.hpp"

namespace markservo::bench {
namespace {

constexpr int kExitDisagree = 1;
constexpr int kExitBadOptions = 2;

struct Options {
  std::string robot_file = "config/robot.yaml";
  std::string picture;
  int num_rounds = 7;
  bool json = false;
};

int run(const Options& options) {
  cv::setNumThreads(1);
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const std::vector<robot::MarkDescription> marks = choose_marks(robot, options.robot_file);
  const geometry::StereoCamera& camera = robot.cameras.stereo;
  const std::vector<scenes::StereoPair> pairs = scenes::render_pairs(robot.cameras, marks, scenes::SceneParameters{});
  if (!options.picture.empty()) {
    cv::Mat both;
    cv::hconcat(pairs.front().left, pairs.front().right, both);
    cv::imwrite(options.picture, both);
    return 0;
  }

  Ours ours(marks, camera, Scan::kWholeImage);
  BaselineAt opencv_chain(marks, camera);
  const Agreement agreement = compare(pairs, camera, ours, opencv_chain);
  const Times times = run_rounds(make_contenders(pairs, marks, camera), options.num_rounds, pairs.size());

  AccuracyParameters soft;
  soft.even_print = false;
  const Accuracy even_print = measure_accuracy(robot, marks, AccuracyParameters{});
  const Accuracy soft_print = measure_accuracy(robot, marks, soft);
  const nlohmann::ordered_json report = report_json(times, agreement, even_print, soft_print, options.num_rounds);
  std::cout << (options.json ? report.dump() + "\n" : report_text(report));
  // Following the marks must not be bought with answers either.
  Ours following(marks, camera, Scan::kTracked);
  std::vector<std::string> complaints = agreement.complaints(AgreementBounds{});
  for (const std::string& complaint : compare(pairs, camera, following, opencv_chain).complaints(AgreementBounds{})) {
    complaints.push_back("following the marks: " + complaint);
  }
  for (const std::string& complaint : complaints) std::cerr << "perception-bench: " << complaint << "\n";
  return complaints.empty() ? 0 : kExitDisagree;
}

}  // namespace
}  // namespace markservo::bench

int main(int argc, char** argv) {
  using namespace markservo;
  bench::Options options;
  CLI::App app("Times our perception beside other ways on the same images, and compares the answers.");
  app.add_option("--robot-file", options.robot_file, "The robot's description: cameras and marks")
      ->capture_default_str();
  app.add_option("--rounds", options.num_rounds, "How often everything is timed")
      ->check(CLI::Range(5, 1000))
      ->capture_default_str();
  app.add_flag("--json", options.json, "Print one JSON object");
  app.add_option("--picture", options.picture, "Write the first image pair to this file and end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bench::kExitBadOptions;
  }
  try {
    return bench::run(options);
  } catch (const std::exception& error) {
    std::cerr << "perception-bench: " << error.what() << "\n";
    return bench::kExitBadOptions;
  }
}
