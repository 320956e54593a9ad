#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace markservo::stack_watch {

// A Unix socket that whoever may open it reads one text from: each connection gets what `answer` returns, and is
// closed.
class AnsweringDevice {
 public:
  // Takes the place of a socket that an earlier process left at `path`. `answer` is called on a thread of its own.
  // Throws std::runtime_error.
  AnsweringDevice(const std::string& path, std::function<std::string()> answer);
  ~AnsweringDevice();
  AnsweringDevice(const AnsweringDevice&) = delete;
  AnsweringDevice& operator=(const AnsweringDevice&) = delete;

 private:
  void serve();

  std::string path_;
  std::function<std::string()> answer_;
  int descriptor_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace markservo::stack_watch
