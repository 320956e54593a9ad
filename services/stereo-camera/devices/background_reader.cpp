#include "services/stereo-camera/devices/background_reader.hpp"

#include <exception>
#include <utility>

namespace markservo::stereo_camera {

BackgroundReader::BackgroundReader(std::unique_ptr<FrameSource> source, Parameters parameters)
    : source_(std::move(source)), parameters_(parameters), thread_([this] { loop(); }) {}

BackgroundReader::~BackgroundReader() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

BackgroundReader::News BackgroundReader::take(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return fresh_; });
  fresh_ = false;
  News news = std::move(news_);
  news_ = News{};
  // These two last until they change.
  news_.waiting = news.waiting;
  news_.ended = news.ended;
  return news;
}

void BackgroundReader::loop() {
  while (true) {
    ReadResult result = read();
    const ReadStatus status = result.status;
    std::unique_lock lock(mutex_);
    note(std::move(result));
    if (status == ReadStatus::kWaiting) changed_.wait_for(lock, parameters_.retry, [this] { return stop_; });
    if (stop_ || status == ReadStatus::kEnd) return;
  }
}

ReadResult BackgroundReader::read() {
  try {
    return source_->read();
  } catch (const std::exception& error) {
    return {ReadStatus::kWaiting, {}, error.what()};
  }
}

void BackgroundReader::note(ReadResult result) {
  switch (result.status) {
    case ReadStatus::kPair:
      if (news_.pair) ++news_.skipped;
      news_.pair = std::move(result.pair);
      news_.waiting = false;
      break;
    case ReadStatus::kDropped:
      ++news_.dropped;
      break;
    case ReadStatus::kWaiting:
      if (!news_.waiting) ++news_.losses;
      news_.waiting = true;
      break;
    case ReadStatus::kEnd:
      news_.ended = true;
      break;
  }
  if (!result.reason.empty()) news_.reason = std::move(result.reason);
  fresh_ = true;
  changed_.notify_all();
}

}  // namespace markservo::stereo_camera
