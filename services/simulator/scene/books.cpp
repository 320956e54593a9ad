#include "services/simulator/scene/books.hpp"

#include <utility>

#include "services/simulator/arm/gripper_mjcf.hpp"
#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {
namespace {

int body_id(const mjModel* model, const std::string& name) {
  return mj_name2id(model, mjOBJ_BODY, name.c_str());
}

// m, z of a body's lowest point.
double lowest_point(const mjModel* model, const mjData* data, int body) {
  const int geom = model->body_geomadr[body];  // the first geom is the book's box
  const Eigen::Vector3d half = vector(model->geom_size + kVector * geom);
  const Eigen::Matrix3d R = matrix(data->geom_xmat + kMatrix * geom);
  return data->geom_xpos[kVector * geom + 2] - R.row(2).cwiseAbs().dot(half);
}

}  // namespace

Books::Books(const mjModel_* model, const BooksScene& books)
    : fingers_{body_id(model, kFingers[0]), body_id(model, kFingers[1])} {
  for (const BookScene& book : books.row) books_.push_back({body_id(model, book.mark)});
}

void Books::note_heights(const mjModel_* model, const mjData_* data) {
  for (Book& book : books_) book.lowest = lowest_point(model, data, book.body);
}

std::vector<BodyTruth> Books::truth(const mjModel_* model, const mjData_* data, const Eigen::Isometry3d& X_CS) const {
  std::vector<BodyTruth> truths;
  for (const Book& book : books_) {
    BodyTruth truth;
    truth.name = mj_id2name(model, mjOBJ_BODY, book.body);
    truth.X_CB.translation() = X_CS * vector(data->xpos + kVector * book.body);
    truth.X_CB.linear() = X_CS.linear() * matrix(data->xmat + kMatrix * book.body);
    truth.height_gain = lowest_point(model, data, book.body) - book.lowest;
    note_contacts(model, data, book.body, truth);
    truths.push_back(std::move(truth));
  }
  return truths;
}

void Books::note_contacts(const mjModel_* model, const mjData_* data, int body, BodyTruth& truth) const {
  for (int i = 0; i < data->ncon; ++i) {
    const int body1 = model->geom_bodyid[data->contact[i].geom1];
    const int body2 = model->geom_bodyid[data->contact[i].geom2];
    if (body1 != body && body2 != body) continue;
    const int other = body1 == body ? body2 : body1;
    if (other == fingers_[0]) {
      truth.touches_left_finger = true;
    } else if (other == fingers_[1]) {
      truth.touches_right_finger = true;
    } else {
      truth.touches_other = true;
    }
  }
}

}  // namespace markservo::simulator
