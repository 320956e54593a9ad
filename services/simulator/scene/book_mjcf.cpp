#include "services/simulator/scene/book_mjcf.hpp"

#include "common/geometry/degrees.hpp"
#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/marks/mark_mjcf.hpp"
#include "services/simulator/model/mjcf_writer.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

const Rgb kPaper(0.86, 0.84, 0.78);
const Rgb kLetters(0.75, 0.74, 0.70);

// Pages at the top and a title on the spine of a book of `size` (m) whose mark is `mark_z` (m) above its centre.
std::string look_of(const Vector3d& size, double mark_z) {
  const double spine_y = -0.5 * size[1];
  std::string out;
  constexpr double kInk = 0.0001;  // m, raised
  const auto look = [&](const Vector3d& centre, const Vector3d& edges, const Rgb& colour) {
    out +=
        "<geom " + at(centre) + " " + box(edges) + " " + coloured(colour) + " material=\"matt\" " + kNoContact + "/>\n";
  };
  look({0.0, 0.003, 0.5 * size[2]}, {0.78 * size[0], size[1] - 0.008, 2 * kInk}, kPaper);
  for (const double z : {-0.034, -0.042, -0.049}) {
    look({0.0, spine_y, mark_z + z}, {0.6 * size[0], 2 * kInk, 0.0035}, kLetters);
  }
  look({0.0, spine_y, mark_z + 0.024}, {size[0], 2 * kInk, 0.002}, kLetters);
  return out;
}

}  // namespace

Eigen::Isometry3d book_pose(const Scene& scene, const BooksSettings& settings, const BookScene& book) {
  const BooksScene& books = scene.books;
  Eigen::Isometry3d X_SB = Eigen::Isometry3d::Identity();
  X_SB.translation() = Vector3d(settings.x, settings.y, books.mark_z) + Vector3d(book.place * books.spacing, 0.0, 0.0);
  X_SB.rotate(Eigen::AngleAxisd(settings.slant_deg * geometry::kRadiansPerDegree, Vector3d::UnitZ()));
  X_SB.translate(
      Vector3d(0.0, kPrintThickness + 0.5 * books.size[1], scene.shelf.top_z + 0.5 * books.size[2] - books.mark_z));
  return X_SB;
}

std::string book_body(const robot::RobotDescription& robot, const Scene& scene, const BooksSettings& settings,
                      const BookScene& book) {
  const BooksScene& books = scene.books;
  const robot::MarkDescription& mark = *robot.find_mark(book.mark);
  const double spine_y = -0.5 * books.size[1];
  const double mark_z = books.mark_z - scene.shelf.top_z - 0.5 * books.size[2];
  Eigen::Isometry3d X_BM = Eigen::Isometry3d::Identity();
  X_BM.translation() << 0.0, spine_y - kPrintThickness, mark_z;

  std::string out = "<body " + named(book.mark) + " " + placed(book_pose(scene, settings, book)) + "><freejoint/>\n";
  out += "<geom " + named(book.mark) + " " + box(books.size) + " mass=\"" + mjcf(books.mass) + "\" " +
         coloured(book.cover) + " material=\"matt\" " + kBookContact + " condim=\"4\" friction=\"" +
         mjcf(settings.friction) + " 0.005 0.0001\" " + kStiff + "/>\n";
  out += print_geom(mark, X_BM);
  out += look_of(books.size, mark_z);
  return out + "</body>\n";
}

}  // namespace markservo::simulator
