#include "common/bus/subscription.hpp"

#include <fmt/format.h>

namespace markservo::bus {
namespace {

// "3600 s" or "0.25 s": as coarse as it may be told again and again.
std::string ahead_text(double seconds) {
  return seconds < 10.0 ? fmt::format("{:.2g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

}  // namespace

void Subscription::note_worked_on() {
  accepted_at_ = std::chrono::steady_clock::now();
}

void Subscription::fail_to_decode(const std::string& why) {
  ++counters_.decode_failures;
  note_refusal(why);
}

void Subscription::refuse(const std::string& why) {
  ++counters_.refused;
  note_refusal(why);
}

void Subscription::note_refusal(const std::string& why) {
  refused_at_ = std::chrono::steady_clock::now();
  refusal_ = why;
  host_->complain(channel_, why);
}

void MessageSubscription::receive(const void* data, std::size_t size) {
  note_arrival();
  if (const std::string why = decode(data, size); !why.empty()) {
    forget();  // what a bad message claimed to need is given back
    return fail_to_decode(why);
  }
  const bool obeyed = mend_if_it_must_be_obeyed();
  std::string why = obeyed ? "" : broken_rule();
  const double ahead = why.empty() ? host_->ahead_of_clock(identity().utime.value_or(0)) : 0.0;
  if (ahead > 0.0 && !obeyed) {
    why = "utime is " + ahead_text(ahead) + " ahead of this host's clock; allowed: at most 20 ms";
  }
  if (!why.empty()) {
    forget();
    return refuse(why);
  }
  accept(ahead > 0.0);
}

void MessageSubscription::accept(bool from_the_future) {
  note_accepted();
  const messages::Identity incoming = identity();
  if (incoming.session && exclusive_) counters_.sequence.observe(*incoming.session, *incoming.seq);
  // A stop of an unknown time or a wrong one tells nothing about it.
  const std::int64_t utime = incoming.utime.value_or(0);
  on_time_line_ = utime != 0 && !from_the_future && host_->note_utime(utime);
  if (on_time_line_) counters_.newest_utime = utime;
  if (waits_) ++counters_.skipped;
  let_wait();
  waits_ = true;
  waiting_utime_ = utime;
  if (delivery_ == Delivery::kEach || host_->replaying()) dispatch();
}

void MessageSubscription::dispatch() {
  if (!waits_) return;
  waits_ = false;
  if (on_time_line_) {
    counters_.latency.add(1e-6 * static_cast<double>(host_->newest_utime() - waiting_utime_),
                          std::chrono::steady_clock::now());
  }
  hand_over();
}

}  // namespace markservo::bus
