#include "services/mmi/log/log_source.hpp"

#include "common/reflection/type_catalog.hpp"
#include "services/mmi/log/log_shown.hpp"

namespace markservo::mmi {

LogSource::LogSource(const std::string& path, const std::string& prefix, const robot::RobotDescription& robot,
                     std::string tag_field, const text::TypedCommand& typed)
    : log_({path}, logs::fit_of(reflection::TypeCatalog::ours())),
      index_(log_, prefix, reflection::TypeCatalog::ours()),
      robot_(robot),
      tag_field_(std::move(tag_field)),
      typed_(typed),
      story_(index_, robot_, typed) {}

std::unique_ptr<WorldReader> LogSource::new_world() const {
  WorldReader::Parameters parameters;
  parameters.narrator.typed = typed_;
  return std::make_unique<WorldReader>(robot_, tag_field_, parameters);
}

std::unique_ptr<Shown> LogSource::shown() {
  return std::make_unique<LogShown>(index_, story_.events(), [this] { return new_world(); });
}

WorldReader& LogSource::world() {
  if (!at_end_) {
    at_end_ = shown();
    at_end_->control(ClientSeek{index_.end()});
  }
  return at_end_->world();
}

std::string LogSource::stop(const std::string& /*reason*/) {
  return "stop of a log; allowed: of a robot";
}

}  // namespace markservo::mmi
