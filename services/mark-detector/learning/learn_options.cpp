#include "services/mark-detector/learning/learn_options.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <opencv2/core.hpp>
#include <sstream>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mark-detector/learning/robot_file_edit.hpp"
#include "services/mark-detector/picture/picture.hpp"
#include "services/mark-detector/picture/picture_file.hpp"

namespace markservo::mark_detector {
namespace {

cv::Rect parse_box(const std::string& text) {
  std::array<int, 4> numbers{};
  std::istringstream stream(text);
  char comma = ',';
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if ((i > 0 && !(stream >> comma)) || comma != ',' || !(stream >> numbers[i])) {
      throw ConfigurationError("--box '" + text + "': cannot be used; allowed: x,y,width,height in whole px");
    }
  }
  if (!stream.eof() || numbers[0] < 0 || numbers[1] < 0 || numbers[2] < 1 || numbers[3] < 1) {
    throw ConfigurationError("--box '" + text +
                             "': cannot be used; allowed: x,y,width,height in whole px, x and y from 0, sizes from 1");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void require_inside(const cv::Rect& box, const std::string& text, const cv::Mat& image, const std::string& path) {
  // Without sums, which could overflow.
  if (box.width <= image.cols && box.height <= image.rows && box.x <= image.cols - box.width &&
      box.y <= image.rows - box.height) {
    return;
  }
  throw ConfigurationError("--box '" + text + "': not within '" + path + "'; allowed: inside its " +
                           std::to_string(image.cols) + " x " + std::to_string(image.rows) + " px");
}

const robot::MarkDescription& find(const robot::RobotDescription& robot, const std::string& name,
                                   const std::string& robot_file) {
  std::string names;
  for (const auto& mark : robot.marks) {
    if (mark.name == name) return mark;
    names += (names.empty() ? "" : ", ") + mark.name;
  }
  throw ConfigurationError("--learn '" + name + "': no such mark in " + robot_file + "; allowed: " + names);
}

}  // namespace

void LearnOptions::add_to(CLI::App& app) {
  const bus::Options add(app);
  const char* const group = "Learn a mark's colour without a bus";
  add.option("--learn", mark_, "Measure this mark's colour in the IMAGEs' boxes and write it into --robot-file")
      .not_in_config()
      .group(group);
  add.option("--box", boxes_, "Where the mark is, x,y,width,height in px: once for all IMAGEs, or once for each")
      .expected(1)
      .take_all()
      .one_at_a_time()
      .not_in_config()
      .group(group);
  add.option("IMAGE", images_, "Pictures of the mark").not_in_config().group(group);
}

void LearnOptions::check() const {
  if (!wanted()) {
    if (!boxes_.empty()) throw ConfigurationError("--box: without --learn; allowed: with --learn NAME");
    if (!images_.empty()) throw ConfigurationError("'" + images_.front() + "': a picture without --learn NAME");
    return;
  }
  if (images_.empty()) throw ConfigurationError("--learn: no picture; allowed: one or more, after --box");
  if (boxes_.size() != 1 && boxes_.size() != images_.size()) {
    throw ConfigurationError("--box: given " + std::to_string(boxes_.size()) + " times for " +
                             std::to_string(images_.size()) + " pictures; allowed: once, or once for each");
  }
}

void LearnOptions::run(const std::string& robot_file, const LearningParameters& learning,
                       const Parameters& detection) const {
  const robot::RobotDescription robot = robot::load_robot_description(robot_file);
  const robot::MarkDescription& mark = find(robot, mark_, robot_file);
  std::vector<cv::Mat> images;  // owns the pixels
  std::vector<LearningPicture> pictures;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const std::string& box_text = boxes_[boxes_.size() == 1 ? 0 : i];
    const cv::Rect box = parse_box(box_text);
    images.push_back(read_picture("IMAGE", images_[i]));
    require_inside(box, box_text, images.back(), images_[i]);
    pictures.push_back({view_of(images.back()), box.x, box.y, box.width, box.height});
  }
  const auto number = static_cast<std::size_t>(&mark - robot.marks.data());
  const MarkLearning learned = learn_mark(robot.marks, number, pictures, learning, detection);
  const LearnedColour& colour = learned.colour;
  if (!colour.failure.empty())
    throw ConfigurationError("--box: " + colour.failure + "; '" + mark_ + "' stays as it is");

  write_colour(robot_file, mark_, colour.interval);
  std::cout << mark_ << ", old: " << to_text(mark.colour) << "\n"
            << mark_ << ", new: " << to_text(colour.interval) << "\n";
  warn(learned);
}

void LearnOptions::warn(const MarkLearning& learned) const {
  const auto say = [](const std::string& text) { std::cerr << "mark-detector: warning: " << text << "\n"; };
  if (!learned.colour.doubt.empty()) say(mark_ + ": " + learned.colour.doubt);
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const std::string& doubt = learned.views[i].doubt;
    if (!doubt.empty()) say(mark_ + " in '" + images_[i] + "': " + doubt);
  }
  for (const OverlappingMark& other : learned.overlaps) say(other.text);
}

}  // namespace markservo::mark_detector
