#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/bench.hpp"
#include "tests/system/fault_campaign/plan.hpp"

namespace markservo::campaign {

// What has to be so before the stack is started.
struct StackSetup {
  std::vector<std::string> arguments;  // of scripts/stack start
  bool settable_clocks = false;        // the services' wall clocks can be set: set_clock()
};

// Beside the trial's wrappers of the services' executables (scripts that look there before they begin):
// what a service's wall clock shall show ("+3600", "+0 x1.01"), and how many files it may open at its next start.
void set_clock(const Bench& bench, const std::string& service, const std::string& faketime);
void limit_descriptors(const Bench& bench, const std::string& service, int most);
void unlimit_descriptors(const Bench& bench, const std::string& service);
// Writes the wrappers into OUT/wrapped/bin; the folder for scripts/stack --build-dir.
std::string wrap_services(const Bench& bench, bool settable_clocks);

// Something that goes wrong, for a while.
class Fault {
 public:
  explicit Fault(FaultPlan plan) : plan_(std::move(plan)) {}
  virtual ~Fault() = default;
  Fault(const Fault&) = delete;
  Fault& operator=(const Fault&) = delete;

  const FaultPlan& plan() const { return plan_; }
  // In a line, for people.
  virtual std::string describe() const = 0;
  // Channels and processes that an honest reason may name.
  virtual std::set<std::string> words() const = 0;
  // Invariants that cannot hold whatever the stack does.
  virtual std::set<std::string> excuses() const { return {}; }
  // Whether a recording may end by this: the disk it is on is the fault's.
  virtual bool ends_recording() const { return false; }

  virtual void prepare(Bench&, StackSetup&) {}
  // Every few milliseconds from then on, whether or not it strikes.
  virtual void attend(Bench&) {}
  virtual void strike(Bench& bench) = 0;
  // Every few milliseconds from the strike to the end.
  virtual void tick(Bench&) {}
  virtual void end(Bench&) {}
  // How it is known that it struck something; empty: it did not.
  virtual std::string evidence() const = 0;

 private:
  FaultPlan plan_;
};

std::unique_ptr<Fault> make_fault(const FaultPlan& plan);

// Each family's own; null for another family's kind.
std::unique_ptr<Fault> make_writer_fault(const FaultPlan& plan);
std::unique_ptr<Fault> make_old_messages(const FaultPlan& plan);
std::unique_ptr<Fault> make_process_fault(const FaultPlan& plan);
std::unique_ptr<Fault> make_network_fault(const FaultPlan& plan);
std::unique_ptr<Fault> make_clock_fault(const FaultPlan& plan);
std::unique_ptr<Fault> make_device_fault(const FaultPlan& plan);

// What names a channel or a process in an honest reason: itself, and what can only be seen of it further on. No words
// that stand in any reason ("stop", "base"): then every reason would name every fault.
std::set<std::string> words_of_channel(const std::string& channel);
std::set<std::string> words_of_service(const std::string& service);
// What a fault on a service's way in may be named by.
std::set<std::string> words_heard_by(const std::string& service);

}  // namespace markservo::campaign
