#include "services/mark-detector/learning/learning_node.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <markservo/LearnWarning.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/channels.hpp>
#include <utility>

#include "common/frames/frame_side.hpp"
#include "common/frames/jpeg_decoder.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/require_mark.hpp"
#include "common/time/clocks.hpp"
#include "common/time/seconds_between.hpp"
#include "services/mark-detector/learning/learn_messages.hpp"
#include "services/mark-detector/learning/robot_file_edit.hpp"
#include "services/mark-detector/picture/picture.hpp"

namespace markservo::mark_detector {
namespace {

constexpr std::size_t kWaitingMost = 2;         // each holds a frame of megabytes
constexpr std::size_t kAnswersMost = 8;         // of one who asks thrice within 3 s, and of who came before
constexpr double kAskerAlone_s = 5.0;           // as long as a display that was left keeps the word
constexpr std::chrono::milliseconds kLook{20};  // how late an answer may be for being looked for
constexpr int kNice = 10;                       // frames go first where processors are short

robot::ColourInterval colour_of(const LearnResult& result) {
  return {result.hue_min_deg,    result.hue_max_deg, result.saturation_min,
          result.saturation_max, result.value_min,   result.value_max};
}

bool answers(const LearnResult& result, const LearnRequest& request) {
  return result.request_session == request.session && result.request_id == request.request_id;
}

}  // namespace

void LearningNode::add_to(CLI::App& app) {
  bus::Options(app).flag("--allow-saving", may_save_,
                         "Write a colour that was learned for LEARN_REQUEST into --robot-file, where it asks for that");
}

void LearningNode::start(bus::Bus& bus, LearningSettings settings, Adopt adopt) {
  replaying_ = bus.replaying();
  settings_ = std::move(settings);
  adopt_ = std::move(adopt);
  results_.emplace(bus.advertise(channels::kLearnResult));
  bus.on_each(channels::kLearnRequest, [this](const LearnRequest& request) { on_request(request); });
  bus.every(kLook, [this] { finish(); });
}

void LearningNode::observe(const StereoFrame& frame) {
  newest_ = Frame{frame.utime, steady_clock_us(), frame.width, frame.height};
}

void LearningNode::on_request(const LearnRequest& request) {
  if (answer_again(request) || is_waiting(request)) return;
  if (!newest_) {
    if (request.offset == 0) refuse(request, "no STEREO_FRAME was heard yet; allowed: while cameras send");
    return;
  }
  if (std::string why = objection_of_now(request); !why.empty()) {
    if (take_up(request)) reject(request, why);
    return;
  }
  std::optional<std::vector<std::uint8_t>> left = picture_with(request);
  if (!left) return;
  if (waiting_.size() >= kWaitingMost) return refuse(request, "others wait already; allowed: once they are answered");
  if (!take_up(request)) return;
  if (std::string why = objection_to_asker(request); !why.empty()) return reject(request, why);
  waiting_.push_back({request, std::move(*left)});
  begin();
}

// Told once a sending: at the first piece.
bool LearningNode::answer_again(const LearnRequest& request) {
  const auto known = std::find_if(answers_.begin(), answers_.end(),
                                  [&request](const LearnResult& result) { return answers(result, request); });
  if (known == answers_.end()) return false;
  if (request.offset == 0) results_->publish(*known);
  return true;
}

bool LearningNode::is_waiting(const LearnRequest& request) const {
  return std::any_of(waiting_.begin(), waiting_.end(), [&request](const Job& job) {
    return job.request.session == request.session && job.request.request_id == request.request_id;
  });
}

// What keeps this request from being learned, whoever sends it.
std::string LearningNode::objection_of_now(const LearnRequest& request) const {
  if (!settings_.obstacle.empty()) return settings_.obstacle;
  if (std::string why = objection_to(request); !why.empty()) return why;
  if (request.frame.width == newest_->width && request.frame.height == newest_->height) return {};
  return "the frame is " + std::to_string(request.frame.width) + " x " + std::to_string(request.frame.height) +
         " px; allowed: STEREO_FRAME's " + std::to_string(newest_->width) + " x " + std::to_string(newest_->height);
}

// Two displays that teach colours at once would undo what the other has just shown.
std::string LearningNode::objection_to_asker(const LearnRequest& request) {
  if (asker_ != 0 && asker_ != request.session &&
      std::abs(seconds_between(asked_utime_, request.utime)) < kAskerAlone_s) {
    return "two write LEARN_REQUEST: sessions " + std::to_string(asker_) + " and " + std::to_string(request.session) +
           "; allowed: the other after 5 s";
  }
  asker_ = request.session;
  asked_utime_ = request.utime;
  return {};
}

// False for one that is too old or was answered long ago: it is told so, and not worked on.
bool LearningNode::take_up(const LearnRequest& request) {
  // Frames are lost where receive buffers are small: by now there may be one that is as much newer.
  const std::int64_t since = replaying_ ? 0 : steady_clock_us() - newest_->heard_at;
  const std::int64_t now = std::clamp(request.utime, newest_->utime, newest_->utime + std::max<std::int64_t>(0, since));
  const motion::CommandStamp stamp{request.session, request.request_id, request.utime};
  switch (inbox_.hear(stamp, now, false)) {
    case motion::CommandHeard::kStale:
      refuse(request, inbox_.why_stale(stamp, now));
      return false;
    case motion::CommandHeard::kAgain:
      refuse(request, "this request_id was answered long ago; allowed: one above all before it");
      return false;
    case motion::CommandHeard::kExecute:
      break;
  }
  return true;
}

// The whole left picture, if this was its last piece.
std::optional<std::vector<std::uint8_t>> LearningNode::picture_with(const LearnRequest& request) {
  const auto size = static_cast<std::size_t>(request.left_size);
  auto one = std::find_if(incomplete_.begin(), incomplete_.end(), [&](const Incomplete& incomplete) {
    return incomplete.session == request.session && incomplete.request_id == request.request_id &&
           incomplete.left.size() == size;
  });
  if (one == incomplete_.end()) {
    if (incomplete_.size() >= kWaitingMost) incomplete_.pop_front();
    one = incomplete_.insert(incomplete_.end(), Incomplete{request.session, request.request_id, PictureAssembly(size)});
  }
  one->left.add(static_cast<std::size_t>(request.offset), request.piece);
  if (!one->left.complete()) return std::nullopt;
  std::vector<std::uint8_t> left = one->left.take();
  incomplete_.erase(one);
  return left;
}

// Works on the first that waits. A log is replayed in the order of its messages: there at once.
void LearningNode::begin() {
  if (waiting_.empty() || under_way_.valid()) return;
  const Job& job = waiting_.front();  // stays where it is until it is answered
  under_way_ = std::async(replaying_ ? std::launch::deferred : std::launch::async, [this, &job] {
    // Of this thread alone, on Linux.
    if (!replaying_) ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
    return learn(job);
  });
  if (replaying_) finish();
}

void LearningNode::finish() {
  if (!under_way_.valid() || under_way_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return;
  LearnResult result = under_way_.get();
  waiting_.pop_front();
  if (result.written) adopt_written(result);
  answer(std::move(result));
  begin();
}

LearnResult LearningNode::learn(const Job& job) const {
  const LearnRequest& request = job.request;
  LearnResult result = answer_to(request);
  try {
    const robot::RobotDescription robot = robot::load_robot_description(settings_.robot_file);
    const auto& mark = robot::require_mark(robot, "mark", request.mark, settings_.robot_file);
    frames::JpegDecoder decoder;
    const cv::Mat left = frames::picture_of(request.frame, job.left, "left", decoder);
    const LearningPicture picture{view_of(left), request.x, request.y, request.width, request.height};
    const auto number = static_cast<std::size_t>(&mark - robot.marks.data());
    fill(result, learn_mark(robot.marks, number, {picture}, settings_.learning, settings_.detection), picture);
    if (result.learned && request.save) save(result);
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  return result;
}

void LearningNode::save(LearnResult& result) const {
  if (!may_save_) {
    result.reason =
        "not saved: not allowed; scripts/stack restart mark-detector --args mark-detector --allow-saving allows it";
  } else if (replaying_) {
    result.reason = "not saved: a log is replayed";
  } else {
    write_colour(settings_.robot_file, result.mark, colour_of(result));
    result.written = 1;
  }
}

void LearningNode::adopt_written(LearnResult& result) const {
  logging::info("{}: {} as LEARN_REQUEST of session {} has it, written into {}", result.mark,
                to_text(colour_of(result)), result.request_session, settings_.robot_file);
  if (adopt_(result.mark, colour_of(result))) return;
  result.reason = "written; the mark is new to services that run: scripts/stack restart";
}

// Not remembered: the same request may come when it can be taken.
void LearningNode::refuse(const LearnRequest& request, const std::string& why) {
  LearnResult result = answer_to(request);
  result.reason = why;
  results_->publish(result);
}

// For good: what is repeated gets the same answer.
void LearningNode::reject(const LearnRequest& request, const std::string& why) {
  LearnResult result = answer_to(request);
  result.reason = why;
  answer(std::move(result));
}

void LearningNode::answer(LearnResult result) {
  results_->publish(result);
  answers_.push_back(std::move(result));
  if (answers_.size() > kAnswersMost) answers_.pop_front();
}

}  // namespace markservo::mark_detector
