#pragma once

// The compiled MuJoCo model of the world and its state. The parts of the world are given both and know their own places
// in them.

#include <cstdint>
#include <memory>

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

struct SceneModel;

class Physics {
 public:
  // The world at the model's own start. Throws ConfigurationError if MuJoCo refuses the model.
  explicit Physics(const SceneModel& scene_model);

  mjModel_* model() const { return model_.get(); }
  mjData_* data() const { return data_.get(); }

  // A number of its own for each that was ever built in this process.
  std::uint64_t id() const { return id_; }

  // Throws std::runtime_error if the state diverged since the start.
  void require_stable() const;

 private:
  struct ModelDeleter {
    void operator()(mjModel_* model) const;
  };
  struct DataDeleter {
    void operator()(mjData_* data) const;
  };

  std::uint64_t id_;
  std::unique_ptr<mjModel_, ModelDeleter> model_;
  std::unique_ptr<mjData_, DataDeleter> data_;
};

}  // namespace markservo::simulator
