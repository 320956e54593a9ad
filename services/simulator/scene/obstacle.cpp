#include "services/simulator/scene/obstacle.hpp"

#include "services/simulator/model/mjcf_writer.hpp"

namespace markservo::simulator {

std::string obstacle_body() {
  const std::string name = named(kObstacle);
  return "<body " + name + " mocap=\"true\"><geom " + name + " " + box({0.3, 0.3, kObstacleHeight}) + " " +
         coloured({0.35, 0.42, 0.40}) + " material=\"matt\"/></body>\n";
}

}  // namespace markservo::simulator
