#include "services/simulator/scene/lamp_mjcf.hpp"

#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {

std::string lamps(const LightScene& light, double vary, std::uint64_t seed) {
  constexpr double kBrightnessVariation = 0.12;  // share either way
  constexpr double kDirectionVariation = 0.25;   // of the direction's length, about 15 degrees
  RandomBits bits(seed_for(seed, streams::kLamps, 0));
  std::string out;
  for (const Lamp& lamp : light.lamps) {
    Eigen::Vector3d direction = lamp.direction.normalized();
    for (int i = 0; i < 3; ++i) direction[i] += vary * kDirectionVariation * bits.symmetric();
    const double brightness = lamp.brightness * (1.0 + vary * kBrightnessVariation * bits.symmetric());
    out += "<light directional=\"true\" castshadow=\"false\" pos=\"0 0 1\" dir=\"" +
           mjcf(Eigen::Vector3d(direction.normalized())) + "\" ambient=\"0 0 0\" specular=\"0 0 0\" diffuse=\"" +
           mjcf(Eigen::Vector3d(brightness, brightness, brightness)) + "\"/>\n";
  }
  return out;
}

}  // namespace markservo::simulator
