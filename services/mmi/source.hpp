#pragma once

#include <memory>
#include <string>

#include "services/mmi/control/desk.hpp"
#include "services/mmi/feed/shown.hpp"

namespace markservo::mmi {

// What is shown: a bus or a log.
class Source {
 public:
  virtual ~Source() = default;

  // For one more client.
  virtual std::unique_ptr<Shown> shown() = 0;
  // For who asks once: now, or at a log's end.
  virtual WorldReader& world() = 0;
  // Sends STOP, until all have echoed. Why it cannot; empty when it does.
  virtual std::string stop(const std::string& reason) = 0;
  virtual const VersionedText& stop_state() const = 0;
  // Where commands come in; null: nowhere.
  virtual Desk* desk() { return nullptr; }
};

}  // namespace markservo::mmi
