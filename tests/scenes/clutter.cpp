#include "tests/scenes/clutter.hpp"

namespace markservo::scenes {

Surface wall(unsigned seed) {
  Surface wall;
  wall.centre = {0.0, 0.45, 0.0};
  wall.width = wall.height = 2.0;
  wall.colour = bgr(30.0, 0.12, 0.7);
  wall.cell = 0.006;
  wall.depth = 0.5;
  wall.seed = seed;
  return wall;
}

Surface muted_book(const Eigen::Vector3d& centre, std::mt19937& random) {
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Surface book;
  book.centre = centre;
  book.width = draw(0.02, 0.06);
  book.height = draw(0.08, 0.20);
  book.colour = bgr(draw(0.0, 360.0), draw(0.0, 0.2), draw(0.25, 0.95));
  book.cell = draw(0.002, 0.01);
  book.depth = draw(0.1, 0.7);
  book.seed = static_cast<unsigned>(random());
  return book;
}

}  // namespace markservo::scenes
