#include "services/mmi/stop/stop_json.hpp"

#include <string>

namespace markservo::mmi {

nlohmann::ordered_json stop_json(const StopView& view) {
  using Json = nlohmann::ordered_json;
  Json devices = Json::array();
  for (const StopDeviceView& device : view.devices) {
    devices.push_back({{"device", device.device},
                       {"state", name_of(device.answer)},
                       {"latched", device.latched ? Json(*device.latched) : Json(nullptr)},
                       {"reason", device.reason}});
  }
  return {{"state", name_of(view.state)}, {"request", std::to_string(view.request_id)}, {"devices", devices}};
}

}  // namespace markservo::mmi
