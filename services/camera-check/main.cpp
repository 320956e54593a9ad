// camera-check: says of a camera pair what is wrong with it, by logs; scripts/doctor --cameras makes them and runs it.
//   in: logs with STEREO_FRAME, MARK_DETECTION, TARGET_POSE     out: standard output

#include <iostream>

#include "common/bus/exit_code.hpp"
#include "common/bus/options.hpp"
#include "common/bus/tool.hpp"
#include "common/reflection/message_json.hpp"
#include "services/camera-check/camera_check_node.hpp"

namespace {

struct CheckOptions {
  std::vector<std::string> logs;
  std::string robot;
  bool json = false;
};

int run(const CheckOptions& options) {
  markservo::camera_check::CameraCheckNode node(options.robot);
  for (const std::string& log : options.logs) node.add_log(log);
  if (options.json) {
    std::cout << markservo::reflection::json_text(node.report()) << "\n";
  }
  bool ok = true;
  for (const auto& each : node.findings()) {
    ok = ok && each.ok;
    if (options.json) continue;
    std::cout << (each.ok ? "ok     " : "WRONG  ") << each.what << "\n";
    if (!each.mend.empty()) std::cout << "       mend: " << each.mend << "\n";
  }
  return ok ? markservo::bus::kExitStopped : markservo::bus::kExitFailed;
}

}  // namespace

int main(int argc, char** argv) {
  CheckOptions options;
  const auto add_options = [&options](CLI::App& app) {
    const markservo::bus::Options add(app);
    add.option("LOG", options.logs,
               "Logs with pairs (STEREO_FRAME), detections (MARK_DETECTION) or poses (TARGET_POSE)")
        .required();
    add.option("--robot", options.robot, "The channels' prefix in the logs");
    add.flag("--json", options.json, "One JSON object instead");
    add.footer("Exits 0 when all is well, 1 when something is wrong, 2 for wrong options, 3 for what is no log.");
  };
  return markservo::bus::run_tool(
      {"camera-check",
       "Says of the newest pair of pictures whether it is dark, blurred, exchanged or not rectified, and "
       "which marks were seen"},
      argc, argv, add_options, [&options] { return run(options); });
}
