#pragma once

// One LCM bus by its URL, held through what happens to the network: opened, lost, opened again. Used by Bus, and by
// who sends what is no message of ours.

#include <chrono>
#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/log_output.hpp"
#include "common/bus/outgoing.hpp"
#include "common/bus/reachability.hpp"

namespace markservo::bus {

// What became of the messages that the network refused.
struct RefusedSends {
  std::int64_t total = 0;
  std::int64_t lately = 0;  // within the last two seconds
  std::string channel;      // of the newest
  std::string reason;       // why the newest was refused, in the system's words
};

class Connection {
 public:
  // `attach` subscribes all that is to be heard at a new LCM instance; nothing for a bus that is only written.
  using Attach = std::function<void(lcm::LCM& lcm)>;
  using Time = std::chrono::steady_clock::time_point;

  Connection(std::string url, Attach attach);

  // Opens it for the first time. False while what is missing may come (trouble() says what). Throws BusUnavailable for
  // what waiting does not mend.
  bool open();

  // Sees to a bus that is lost: asks four times a second whether it is back, where finding out takes a moment every two
  // seconds, and opens it anew, which joins the multicast group again. True if it was opened in this call.
  bool mend(Time now);
  // The bus is read no more, or hears nothing: mend() opens it anew.
  void lose(const std::string& why, Time now);

  // False if the network refuses the message, which is counted; it is not kept. Whatever is sent next is tried again.
  bool publish(const Outgoing& message, Time now);

  // Of a log: throws LogNotWritten unless all that was published is written. Nothing for a bus.
  void finish();

  // As lcm::LCM::handleTimeout(): above 0 if a message was handled, below when it cannot be read.
  int handle(std::chrono::milliseconds timeout);

  // Null while there is no instance.
  lcm::LCM* lcm() const { return lcm_.get(); }
  // Readable when messages wait; -1 while there is no instance.
  int descriptor() const { return descriptor_; }
  // How often it was opened.
  int openings() const { return openings_; }
  bool is_open() const { return lcm_ != nullptr && !lost_; }
  // Why it is not open, and what to do; empty while it is.
  const std::string& trouble() const { return trouble_; }
  RefusedSends refused_sends(Time now) const;
  const std::string& url() const { return url_; }

 private:
  bool try_to_open();
  bool put(const Outgoing& message);

  std::string url_;
  Attach attach_;
  std::unique_ptr<lcm::LCM> lcm_;
  std::unique_ptr<LogOutput> log_;  // of a file:// URL that is written: then `lcm_` carries and hears nothing
  int descriptor_ = -1;
  int openings_ = 0;
  bool lost_ = false;
  std::string trouble_;
  Time asked_{};
  std::chrono::milliseconds ask_again_{0};
  RefusedSends refused_;
  Time refused_at_{};
};

}  // namespace markservo::bus
