#include "services/stereo-camera/files/file_source.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "services/stereo-camera/files/schedule.hpp"
#include "services/stereo-camera/pairs/side_by_side.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kUsualRate_hz = 30.0;

ReadResult dropped(const std::string& reason) {
  return {ReadStatus::kDropped, {}, reason};
}

double seconds(std::int64_t time_us) {
  return 1e-6 * static_cast<double>(time_us);
}

}  // namespace

FileSource::FileSource(std::unique_ptr<ImageStream> left, std::unique_ptr<ImageStream> right, bool loop,
                       std::int64_t right_ahead_us)
    : left_(std::move(left), 0), right_(std::in_place, std::move(right), -right_ahead_us), loop_(loop) {}

FileSource::FileSource(std::unique_ptr<ImageStream> side_by_side, bool loop)
    : left_(std::move(side_by_side), 0), loop_(loop) {}

std::int64_t FileSource::period_us() const {
  const double rate = std::max(left_.rate(), right_ ? right_->rate() : 0.0);
  return time_of(0, 1, rate > 0.0 ? rate : kUsualRate_hz);
}

ReadResult FileSource::read() {
  ReadResult result = right_ ? read_two() : read_side_by_side();
  if (result.status == ReadStatus::kEnd) return result;
  result.pair.index = next_index_++;
  if (result.status == ReadStatus::kPair) {
    result.pair.time_us += round_shift_us_;
    last_us_ = result.pair.time_us;
    ++pairs_this_round_;
  }
  return result;
}

ReadResult FileSource::read_two() {
  while (!left_.ended() && !right_->ended()) {
    const Upcoming left = left_.upcoming();
    const Upcoming right = right_->upcoming();
    const Pairing pairing = pair_recorded(left, right, period_us());
    if (pairing == Pairing::kPair) return pair_two();
    const bool drop_left = pairing == Pairing::kDropLeft;
    const double time_s = seconds(drop_left ? left.next_us : right.next_us);
    (drop_left ? left_ : *right_).take();
    // That one recording begins before the other is no loss.
    if (matched_this_round_ == 0) continue;
    return dropped(fmt::format("{} picture at {:.3f} s has no partner within half a period",
                               drop_left ? "left" : "right", time_s));
  }
  return end(reason_of_the_end());
}

ReadResult FileSource::pair_two() {
  const std::string beginning = reason_of_the_beginning();
  ++matched_this_round_;
  StreamResult left = left_.take();
  StreamResult right = right_->take();
  if (left.status == StreamStatus::kUnreadable) return dropped(left.reason);
  if (right.status == StreamStatus::kUnreadable) return dropped(right.reason);
  // The middle of both, so that neither side is favoured.
  const std::int64_t time_us = left.time_us + (right.time_us - left.time_us) / 2;
  return {ReadStatus::kPair, {std::move(left.image), std::move(right.image), 0, time_us, std::nullopt}, beginning};
}

ReadResult FileSource::read_side_by_side() {
  if (left_.ended()) return end("");
  const StreamResult both = left_.take();
  if (both.status == StreamStatus::kUnreadable) return dropped(both.reason);
  const auto halves = split_side_by_side(both.image);
  if (!halves) {
    return dropped("side-by-side picture is " + size_text(both.image.size()) + "; allowed: an even width");
  }
  return {ReadStatus::kPair, {halves->left, halves->right, 0, both.time_us, std::nullopt}, ""};
}

std::string FileSource::reason_of_the_beginning() const {
  if (matched_this_round_ > 0 || left_.taken() + right_->taken() == 0) return "";
  return fmt::format("before the first pair, {} pictures of the left and {} of the right are left out", left_.taken(),
                     right_->taken());
}

std::string FileSource::reason_of_the_end() const {
  const LookaheadStream& shorter = left_.ended() ? left_ : *right_;
  const char* side = left_.ended() ? "left" : "right";
  if (matched_this_round_ == 0 && shorter.taken() > 0) {
    return fmt::format(
        "none of the {}'s {} pictures is within half a period ({} ms) of one of the other side's; "
        "allowed: videos of the same time, with --offset-s or --estimate-offset where their clocks differ",
        side, shorter.taken(), period_us() / 2000);
  }
  if (left_.ended() && right_->ended()) return "";
  return fmt::format("{} ends after {} pictures, the other side goes on; stopped at the shorter", side,
                     shorter.taken());
}

ReadResult FileSource::end(const std::string& reason) {
  // A round without a single pair would be looped over for ever.
  if (!loop_ || pairs_this_round_ == 0) return {ReadStatus::kEnd, {}, reason};
  pairs_this_round_ = 0;
  matched_this_round_ = 0;
  left_.rewind();
  if (right_) right_->rewind();
  round_shift_us_ = 0;
  ReadResult result = right_ ? read_two() : read_side_by_side();
  round_shift_us_ = last_us_ + period_us() - result.pair.time_us;
  if (result.reason.empty()) result.reason = reason;
  return result;
}

}  // namespace markservo::stereo_camera
