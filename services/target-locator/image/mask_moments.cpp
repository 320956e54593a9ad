#include "services/target-locator/image/mask_moments.hpp"

namespace markservo::target_locator {

MaskMoments moments_of(const Mask& mask) {
  MaskMoments m;
  double sx = 0.0;
  double sy = 0.0;
  for_each_run(mask, [&](int y, int begin, int end) {
    const double n = end - begin;
    m.n += n;
    sx += n * 0.5 * (begin + end - 1);
    sy += n * y;
  });
  if (!(m.n > 0.0)) return m;
  m.centre = {sx / m.n, sy / m.n};
  for_each_run(mask, [&](int row, int begin, int end) {
    // A run's moments about its own middle, then about the centre.
    const double n = end - begin;
    const double y = row - m.centre.y();
    const double x = 0.5 * (begin + end - 1) - m.centre.x();
    const double second = n * (n * n - 1.0) / 12.0;
    const double fourth = second * (3.0 * n * n - 7.0) / 20.0;
    const double xx = second + n * x * x;
    const double xxx = (3.0 * second + n * x * x) * x;
    const double xxxx = fourth + (6.0 * second + n * x * x) * x * x;
    m.xx += xx;
    m.xy += n * x * y;
    m.yy += n * y * y;
    m.fourth[0] += xxxx;
    m.fourth[1] += xxx * y;
    m.fourth[2] += xx * y * y;
    m.fourth[3] += n * x * y * y * y;
    m.fourth[4] += n * y * y * y * y;
  });
  m.xx /= m.n;
  m.xy /= m.n;
  m.yy /= m.n;
  for (double& value : m.fourth) value /= m.n;
  return m;
}

}  // namespace markservo::target_locator
