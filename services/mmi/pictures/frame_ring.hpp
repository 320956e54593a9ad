#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/reflection/message_value.hpp"
#include "services/mmi/scene/message_slots.hpp"

namespace markservo::mmi {

// What answers a frame, in the order of the chain.
enum class FramePart { kDetection, kMatches, kPose, kServo };
inline constexpr std::size_t kFrameParts = 4;

struct Frame {
  std::int64_t session = 0;
  std::int64_t seq = 0;
  std::int64_t utime = 0;                // us, the exposure's middle
  std::int64_t at = 0;                   // us, arrival
  double heard = 0.0;                    // s, of the same clock as `now`
  Bytes bytes;                           // the STEREO_FRAME
  std::array<Bytes, kFrameParts> parts;  // null: not heard

  const Bytes& part(FramePart which) const { return parts[static_cast<std::size_t>(which)]; }
};

// The newest frames, each with the messages that answer it: they are joined by the frame's own name, never by time.
class FrameRing {
 public:
  struct Parameters {
    std::size_t frames = 8;     // an answer comes within 3 frames, even at 60 Hz
    double patience = 0.1;      // s, after which a picture is shown without what has not come, or longer where answers
                                // take longer: kSlack of their median
    double patience_max = 0.5;  // s: an older picture would tell less than one without answers
    std::size_t delays = 60;    // of each channel: 2 s at 30 Hz
  };

  FrameRing() : FrameRing(Parameters{}) {}
  explicit FrameRing(const Parameters& parameters) : parameters_(parameters) {}

  // A STEREO_FRAME, decoded; `bytes` are its own.
  void add(const reflection::Fields& fields, Bytes bytes, std::int64_t at, double now);
  // Whether messages of `channel` answer frames.
  static bool is_answer(std::string_view channel);
  // A message of such a channel.
  void join(std::string_view channel, const reflection::Fields& fields, const Bytes& bytes, std::int64_t at);

  // The newest frame that has all of its answers, or has waited for them long enough; null: none.
  std::shared_ptr<const Frame> ready(double now) const;
  // That which arrived at `at` (us); null: it is not here.
  std::shared_ptr<const Frame> of(std::int64_t at) const;
  std::shared_ptr<const Frame> newest() const { return frames_.empty() ? nullptr : frames_.back(); }

  // s, from the frame's arrival to its answers', the median of the last ones, by channel.
  std::map<std::string, double> delays() const;

 private:
  double patience_by_delays() const;

  Parameters parameters_;
  std::deque<std::shared_ptr<Frame>> frames_;
  std::map<std::string, std::deque<double>> delays_;
  double patience_ = parameters_.patience;  // s, how long the answers of a frame are waited for
};

}  // namespace markservo::mmi
