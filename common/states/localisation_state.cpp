#include "common/states/localisation_state.hpp"

namespace markservo {

const char* name_of(LocalisationState state) {
  switch (state) {
    case LocalisationState::kSearching:
      return "searching";
    case LocalisationState::kLocalised:
      return "localised";
    case LocalisationState::kLost:
      return "lost";
  }
  return "unknown";
}

}  // namespace markservo
