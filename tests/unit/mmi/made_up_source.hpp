#pragma once

// A source without a bus or a log: nothing has been heard yet.

#include <memory>
#include <string>

#include "services/mmi/source.hpp"
#include "tests/unit/mmi/robot_of_the_project.hpp"

namespace markservo::mmi {

class MadeUpSource final : public Source {
 public:
  std::unique_ptr<Shown> shown() override { return nullptr; }
  WorldReader& world() override { return world_; }
  std::string stop(const std::string& /*reason*/) override { return {}; }
  const VersionedText& stop_state() const override { return stop_state_; }

 private:
  WorldReader world_{robot_of_the_project(), ""};
  VersionedText stop_state_;
};

}  // namespace markservo::mmi
