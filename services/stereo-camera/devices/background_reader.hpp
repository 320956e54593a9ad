#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

// Reads a blocking source in a thread of its own and keeps the newest pair: last wins.
class BackgroundReader {
 public:
  struct Parameters {
    std::chrono::milliseconds retry{1000};  // between attempts to open a lost camera
  };

  explicit BackgroundReader(std::unique_ptr<FrameSource> source) : BackgroundReader(std::move(source), Parameters{}) {}
  BackgroundReader(std::unique_ptr<FrameSource> source, Parameters parameters);
  ~BackgroundReader();
  BackgroundReader(const BackgroundReader&) = delete;
  BackgroundReader& operator=(const BackgroundReader&) = delete;

  // What happened since the last call.
  struct News {
    std::optional<RawPair> pair;  // the newest
    std::int64_t dropped = 0;     // by the source
    std::int64_t skipped = 0;     // pairs that a newer one replaced before anybody took them
    std::int64_t losses = 0;      // times that a camera went away
    bool waiting = false;         // the camera is away now
    bool ended = false;
    std::string reason;  // of the last drop or wait
  };

  // Waits up to `timeout` for news.
  News take(std::chrono::milliseconds timeout);

 private:
  void loop();
  ReadResult read();
  void note(ReadResult result);

  std::unique_ptr<FrameSource> source_;
  Parameters parameters_;
  std::mutex mutex_;
  std::condition_variable changed_;
  News news_;
  bool fresh_ = false;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace markservo::stereo_camera
