#pragma once

// How many pairs came out and were lost, and whether the cameras are there: what SERVICE_STATUS says of the capture.

#include <cstdint>
#include <string>

namespace markservo::stereo_camera {

class CaptureRecord {
 public:
  void publish() { ++published_; }
  void drop(const std::string& reason, std::int64_t pairs);
  // The cameras went away so often.
  void lose(std::int64_t times) { losses_ += times; }
  // Whether they are away now, and why (empty: as before). True when that changed.
  bool wait(bool waiting, const std::string& reason);

  std::int64_t published() const { return published_; }
  std::int64_t dropped() const { return dropped_; }

  struct Health {
    std::string state;  // "ready", "waiting"
    std::string reason;
  };
  // What SERVICE_STATUS says of it; to be called once a second: drops are told as those since the last call.
  Health next_health();

 private:
  std::int64_t published_ = 0;
  std::int64_t dropped_ = 0;
  std::int64_t dropped_told_ = 0;
  std::int64_t losses_ = 0;
  bool waiting_ = false;
  std::string last_reason_;
};

}  // namespace markservo::stereo_camera
