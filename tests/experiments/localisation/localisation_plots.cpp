#include "tests/experiments/localisation/localisation_plots.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace markservo::experiments {
namespace {

constexpr double kCentimetres = 100.0;
constexpr double kPlanMargin = 0.12;  // m, around the way

std::string path_of(const CaseResult& result, const std::string& folder, const std::string& rest) {
  return (std::filesystem::path(folder) / ("localisation-" + result.the_case.name + rest)).string();
}

void draw(const std::string& script_file, const std::string& script) {
  std::ofstream(script_file) << script;
  if (std::system(("gnuplot '" + script_file + "'").c_str()) != 0) {
    std::printf("no picture: gnuplot did not run on %s\n", script_file.c_str());
  }
}

// Rows of a gnuplot data block, in cm.
template <class Points, class Position>
std::string block(const std::string& name, const Points& points, const Position& position) {
  std::string text = "$" + name + " << EOD\n";
  for (const auto& point : points) {
    const Eigen::Vector2d p = kCentimetres * position(point);
    text += std::to_string(p.x()) + " " + std::to_string(p.y()) + "\n";
  }
  return text + "EOD\n";
}

}  // namespace

void plot_errors(const CaseResult& result, const std::string& folder) {
  const RunPicture& run = result.picture;
  if (run.paper.empty() || run.truth.empty()) return;
  const TruePath path(run.truth);
  std::string data = "$errors << EOD\n";
  for (const PaperError& error : run.paper) {
    const double way = (path.at(error.time).p_WR - run.truth.front().p_WR).norm();
    data += std::to_string(kCentimetres * way);
    for (const Eigen::Vector2d& e : {error.measured, error.compensated, error.fused}) {
      data += " " + std::to_string(kCentimetres * e.x()) + " " + std::to_string(kCentimetres * e.y());
    }
    data += "\n";
  }
  data += "EOD\n";
  const auto axes = table_axes(result.the_case);
  std::string script = data + "set terminal svg size 760," + std::to_string(320 * axes.size() + 40) +
                       " font 'Sans,12' background 'white'\nset output '" + path_of(result, folder, "-errors.svg") +
                       "'\nset multiplot layout " + std::to_string(axes.size()) +
                       ",1 title 'Error over the course: " + result.the_case.course +
                       "'\nset grid\nset key outside right\nset xlabel 'way, cm'\nset xzeroaxis lt -1\n";
  for (const Axis axis : axes) {
    const std::string name = axis == Axis::kX ? "x" : "y";
    const int column = axis == Axis::kX ? 2 : 3;
    const auto curve = [&](int offset, const std::string& title, const std::string& style) {
      return "$errors using 1:" + std::to_string(column + offset) + " with linespoints " + style + " title '" + title +
             "'";
    };
    script += "set ylabel 'error in " + name + ", cm'\nplot " + curve(0, name + " measured", "pt 6 lc '#c44e52'") +
              ", " + curve(2, name + " compensated", "pt 4 lc '#dd8452'") + ", " +
              curve(4, "ours", "pt 7 lw 2 lc '#3f8f5f'") + "\n";
  }
  draw(path_of(result, folder, "-errors.gnuplot"), script + "unset multiplot\n");
}

void plot_plan(const CaseResult& result, const std::string& folder) {
  const RunPicture& run = result.picture;
  if (run.truth.empty()) return;
  Eigen::Vector2d least = run.truth.front().p_WR;
  Eigen::Vector2d greatest = least;
  for (const auto& point : run.truth) {
    least = least.cwiseMin(point.p_WR);
    greatest = greatest.cwiseMax(point.p_WR);
  }
  const double radius = result.the_case.robot.reading_radius.value_or(0.10);
  least.array() -= radius + kPlanMargin;
  greatest.array() += radius + kPlanMargin;
  const Eigen::Vector2d size = greatest - least;
  // As many pixels per centimetre both ways, beside a key; a long field lies higher than it is wide.
  const double scale = 700.0 / size.maxCoeff();
  const std::string data = block("tags", run.tags, [](const auto& tag) { return tag; }) +
                           block("truth", run.truth, [](const auto& point) { return point.p_WR; }) +
                           block("measured", run.reads, [](const auto& read) { return read.measured; }) +
                           block("ours", run.estimates, [](const auto& pose) { return pose.p_WR; });
  const std::string tics = size.maxCoeff() > 2.0 ? "50" : "20";
  const auto range = [&](int axis) {
    return "[" + std::to_string(kCentimetres * least[axis]) + ":" + std::to_string(kCentimetres * greatest[axis]) + "]";
  };
  draw(path_of(result, folder, "-plan.gnuplot"),
       data + "set terminal svg size " + std::to_string(static_cast<int>(size.x() * scale) + 320) + "," +
           std::to_string(static_cast<int>(size.y() * scale) + 120) +
           " font 'Sans,12' background 'white'\nset output '" + path_of(result, folder, "-plan.svg") +
           "'\nset title '" + result.the_case.course + " from above'\nset size ratio -1\nset xrange " + range(0) +
           "\nset yrange " + range(1) + "\nset xtics " + tics + "\nset ytics " + tics +
           "\nset xlabel 'x, cm'\nset ylabel 'y, cm'\nset key outside right\n"
           "plot $tags with points pt 4 ps 0.6 lc '#aaaaaa' title 'tags', "
           "$truth with lines lw 2 lc 'black' title 'true way', "
           "$measured with points pt 6 lc '#c44e52' title 'weighted average', "
           "$ours with points pt 7 ps 0.35 lc '#3f8f5f' title 'ours'\n");
}

}  // namespace markservo::experiments
