#pragma once

#include <markservo/StereoFrame.hpp>
#include <string>
#include <vector>

namespace markservo::replay {

// A folder that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

// Runs the service `name` of this build until it ends; its exit code. What it says goes to `folder`/NAME.log.
int run_service_alone(const TemporaryFolder& folder, const std::string& name,
                      const std::vector<std::string>& arguments);

// The same with --lcm-in and --lcm-out as logs of `folder`.
int run_through(const TemporaryFolder& folder, const std::string& name, const std::string& in, const std::string& out,
                std::vector<std::string> arguments);

}  // namespace markservo::replay
