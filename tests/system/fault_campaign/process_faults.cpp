// Faults of processes: hangs, deaths, a second one, no descriptors.

#include <sys/types.h>

#include <csignal>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

class ProcessFault : public Fault {
 public:
  using Fault::Fault;
  std::set<std::string> words() const override { return words_of_service(plan().service); }
  std::string evidence() const override { return evidence_; }

 protected:
  const std::string& service() const { return plan().service; }
  void saw(const std::string& evidence) { evidence_ = evidence; }

 private:
  std::string evidence_;
};

class Hang : public ProcessFault {
 public:
  using ProcessFault::ProcessFault;
  std::string describe() const override { return text("%s hangs for %.2f s", service().c_str(), plan().duration); }
  void strike(Bench& bench) override {
    pid_ = bench.pid_of(service());
    if (pid_ > 0 && ::kill(pid_, SIGSTOP) == 0) saw(text("process %d was stopped", pid_));
  }
  void end(Bench&) override {
    if (pid_ > 0) ::kill(pid_, SIGCONT);
  }

 private:
  int pid_ = 0;
};

class Kill : public ProcessFault {
 public:
  using ProcessFault::ProcessFault;
  std::string describe() const override { return service() + " is killed"; }
  void strike(Bench& bench) override {
    const int pid = bench.pid_of(service());
    if (pid > 0 && ::kill(pid, SIGKILL) == 0) saw(text("process %d was killed", pid));
  }
};

class CrashLoop : public ProcessFault {
 public:
  using ProcessFault::ProcessFault;
  std::string describe() const override {
    return text("%s is killed whenever it lives, for %.1f s", service().c_str(), plan().duration);
  }
  void strike(Bench&) override { next_ = Bench::now(); }
  void tick(Bench& bench) override {
    if (Bench::now() < next_) return;
    next_ = Bench::now() + 300'000;
    const int pid = bench.pid_of(service());
    if (pid > 0 && ::kill(pid, SIGKILL) == 0) saw(text("killed %d times", ++times_));
  }

 private:
  std::int64_t next_ = 0;
  int times_ = 0;
};

// It is started where it may open no more than a few files. That ends a service with code 3 and is not tried again: a
// person starts it, when there are descriptors.
class NoDescriptors : public ProcessFault {
 public:
  using ProcessFault::ProcessFault;
  std::string describe() const override {
    return text("%s starts with %.0f descriptors", service().c_str(), plan().amount);
  }
  void strike(Bench& bench) override {
    limit_descriptors(bench, service(), static_cast<int>(plan().amount));
    const int pid = bench.pid_of(service());
    if (pid > 0 && ::kill(pid, SIGKILL) == 0)
      saw(text("process %d was killed; the next one may open %.0f files", pid, plan().amount));
  }
  void end(Bench& bench) override {
    unlimit_descriptors(bench, service());
    bench.run("restart-" + service(), bench.stack_command("start", {service()}));
  }
};

// Somebody starts a service once more, on the same bus.
class SecondProcess : public ProcessFault {
 public:
  using ProcessFault::ProcessFault;
  std::string describe() const override {
    return text("a second %s, started as a %s", service().c_str(), plan().variant.c_str());
  }
  void strike(Bench& bench) override {
    const std::string robot = bench.folders().repository + "/config/robot.yaml";
    if (plan().variant == "stack") {
      child_ = bench.start("second-" + service(), {bench.folders().repository + "/scripts/stack", "start",
                                                   "--runtime-dir", other(bench), "--build-dir", bench.folders().build,
                                                   "--log-dir", bench.folders().out + "/second", service()});
    } else {
      child_ = bench.start("second-" + service(), {bench.folders().build + "/bin/" + service(), "--robot-file", robot});
    }
    began_ = Bench::now();
  }
  void end(Bench& bench) override {
    const bool stack = plan().variant == "stack";
    if (stack) bench.listen(20.0, [&] { return child_->ended(); });
    const bool ended = child_->ended();
    if (stack && ended && child_->exit_code() != 0) {
      saw(text("scripts/stack start exited with %d", child_->exit_code()));
    } else {
      saw(text("it ran for %.1f s", seconds_between(began_, Bench::now())));
    }
    if (stack) {
      bench.run("second-stop", {bench.folders().repository + "/scripts/stack", "stop", "--runtime-dir", other(bench)});
    }
    child_.reset();
  }

 private:
  static std::string other(const Bench& bench) { return bench.folders().runtime + "-2"; }
  std::unique_ptr<Child> child_;
  std::int64_t began_ = 0;
};

}  // namespace

std::unique_ptr<Fault> make_process_fault(const FaultPlan& plan) {
  if (plan.kind == "hang") return std::make_unique<Hang>(plan);
  if (plan.kind == "kill") return std::make_unique<Kill>(plan);
  if (plan.kind == "crash-loop") return std::make_unique<CrashLoop>(plan);
  if (plan.kind == "no-descriptors") return std::make_unique<NoDescriptors>(plan);
  if (plan.kind == "second-process") return std::make_unique<SecondProcess>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
