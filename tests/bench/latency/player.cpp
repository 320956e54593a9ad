#include "tests/bench/latency/player.hpp"

#include <algorithm>
#include <lcm/lcm-cpp.hpp>
#include <stdexcept>
#include <utility>

#include "common/bus/session.hpp"
#include "common/time/clocks.hpp"
#include "tests/bench/resting_arm.hpp"

namespace markservo::bench {
namespace {

using std::chrono::milliseconds;

constexpr double kWarmUp = 0.3;              // s of frames before those that count
constexpr milliseconds kGrace{500};          // for the last answers; longer ones count as lost
constexpr milliseconds kPatience{20'000};    // for processes to start
constexpr milliseconds kProbePeriod{100};    // between frames meanwhile
constexpr std::size_t kSizedFrames = 16;     // answers whose sizes are looked at
constexpr milliseconds kLongestWait{1'000};  // of LCM at a time

double seconds_of(std::chrono::steady_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

std::size_t median_size(std::vector<std::size_t> sizes) {
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

}  // namespace

Player::Player(Route route, const robot::JointVector& arm_at)
    : route_(std::move(route)),
      out_(route_.url),
      session_(bus::random_session()),
      joints_(&sink_, channels::kJointState.name, session_),
      joint_state_(resting_arm(arm_at)) {
  if (!out_.good()) throw std::runtime_error("bus " + route_.url + ": cannot be joined");
}

void Player::receive(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/, Ear* ear) {
  const std::optional<std::int64_t> frame = ear->what->frame_of(buffer->data, buffer->data_size);
  if (frame) ear->heard(ear->stage, *frame, buffer->data_size);
}

void Player::Listener::listen_until(Clock::time_point end) {
  for (auto now = Clock::now(); now < end; now = Clock::now()) {
    const auto wait = std::min(kLongestWait, std::chrono::ceil<milliseconds>(end - now));
    if (lcm->handleTimeout(static_cast<int>(wait.count())) < 0) throw std::runtime_error("the bus cannot be read");
  }
}

Player::Listener Player::listen(Listening listening, const Heard& heard) const {
  Listener listener{std::make_unique<lcm::LCM>(route_.url), {}};
  if (!listener.lcm->good()) throw std::runtime_error("bus " + route_.url + ": cannot be joined");
  const std::size_t first = listening == Listening::kEveryStage ? 0 : route_.stages.size() - 1;
  for (std::size_t stage = first; stage < route_.stages.size(); ++stage) {
    listener.ears.push_back(std::make_unique<Ear>(Ear{stage, &route_.stages[stage], heard}));
    listener.lcm->subscribeFunction(route_.stages[stage].channel, receive, listener.ears.back().get());
  }
  return listener;
}

void Player::encode_next(std::vector<StereoFrame>& frames) {
  StereoFrame& frame = frames[next_frame_++ % frames.size()];
  frame.utime = wall_clock_us();
  frame.session = session_;
  frame.seq = ++seq_;
  buffer_.resize(static_cast<std::size_t>(frame.getEncodedSize()));
  if (frame.encode(buffer_.data(), 0, static_cast<int>(buffer_.size())) < 0) {
    throw std::logic_error("Player: a frame's length field disagrees with its vector");
  }
  if (route_.stamp != nullptr) route_.stamp(buffer_, seq_);
}

void Player::send_frame() {
  if (out_.publish(route_.frame_channel, buffer_.data(), static_cast<unsigned int>(buffer_.size())) < 0) {
    throw std::runtime_error(route_.frame_channel + ": the bus refused the frame");
  }
}

void Player::send_joints() {
  joint_state_.utime = wall_clock_us();
  joints_.publish(joint_state_);
}

std::vector<std::size_t> Player::wait_until_answered(std::vector<StereoFrame>& frames) {
  std::vector<std::vector<std::size_t>> sizes(route_.stages.size());
  Listener listener = listen(Listening::kEveryStage,
                             [&](std::size_t stage, std::int64_t, std::size_t size) { sizes[stage].push_back(size); });
  const auto give_up = Clock::now() + kPatience;
  while (sizes.back().size() < kSizedFrames) {
    if (Clock::now() > give_up) {
      const auto silent = std::find_if(sizes.begin(), sizes.end(), [](const auto& heard) { return heard.empty(); });
      const auto stage = static_cast<std::size_t>(std::min(silent, sizes.end() - 1) - sizes.begin());
      throw std::runtime_error(route_.stages[stage].name + " wrote too few " + route_.stages[stage].channel +
                               " within " + std::to_string(kPatience.count() / 1000) + " s");
    }
    send_joints();
    encode_next(frames);
    send_frame();
    listener.listen_until(Clock::now() + kProbePeriod);
  }
  std::vector<std::size_t> medians;
  for (const auto& heard : sizes) medians.push_back(median_size(heard));
  return medians;
}

void Player::play(std::vector<StereoFrame>& frames, double rate, int count, Listening listening, FrameLedger& ledger) {
  int answered = 0;
  Listener listener = listen(listening, [&](std::size_t stage, std::int64_t frame, std::size_t) {
    if (ledger.came_in(stage, frame, seconds_of(Clock::now()))) ++answered;
  });
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / rate));
  const int num_warm_up = static_cast<int>(kWarmUp * rate);
  auto due = Clock::now();
  for (int i = -num_warm_up; i < count; ++i, due += period) {
    listener.listen_until(due - period / 2);
    send_joints();
    listener.listen_until(due);
    encode_next(frames);
    if (i >= 0) ledger.sent(seq_, seconds_of(Clock::now()));
    send_frame();
  }
  const auto end = Clock::now() + kGrace;
  while (answered < count && Clock::now() < end) listener.listen_until(Clock::now() + milliseconds(1));
}

}  // namespace markservo::bench
