#pragma once

// All of a live bus, heard as bytes, by tools that watch and write nothing.

#include <chrono>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "common/bus/heard_bytes.hpp"

namespace markservo::bus {

class Listener {
 public:
  using Handler = std::function<void(const HeardBytes& message)>;

  // Hears the channels whose whole name matches `pattern` (a regular expression); `queue` messages wait while nobody
  // polls, beyond them liblcm drops. The signals that end a tool are noted (told_to_end()). Throws BusUnavailable.
  Listener(const std::string& url, const std::string& pattern, int queue, Handler handler);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  // Waits so long for a message, and handles it and what waits behind it. Throws BusUnavailable.
  void poll(std::chrono::milliseconds timeout);
  // Readable when messages wait: for who waits on more than this, with poll(2), and then calls poll(0).
  int descriptor() { return lcm_.getFileno(); }

 private:
  static void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel, Listener* listener);

  std::string url_;
  Handler handler_;
  lcm::LCM lcm_;
};

}  // namespace markservo::bus
