#include "services/visual-servo/laws/paper_law.hpp"

#include <algorithm>

namespace markservo::visual_servo {

Eigen::Vector3d paper_error(const robot::PaperLawDescription& law, const Eigen::Vector3d& p_CM,
                            const Eigen::Vector3d& p_CT, const Eigen::Vector3d& shift_TG) {
  return p_CM - (p_CT + law.offset_TM + shift_TG);
}

robot::JointVector paper_step(const robot::PaperLawDescription& law, const Eigen::Vector3d& error, double seconds,
                              double joint_speed) {
  const robot::JointVector rate = law.gains.cwiseProduct(error);
  return rate.cwiseMax(-joint_speed).cwiseMin(joint_speed) * seconds;
}

}  // namespace markservo::visual_servo
