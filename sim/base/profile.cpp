#include "sim/base/profile.h"

namespace robosim {

Profile profile_of(std::string_view name) {
  return name == "ideal"       ? Profile::ideal
         : name == "typical@1" ? Profile::typical_1
         : name == "typical@2" ? Profile::typical_2
                               : Profile::typical;
}

std::string to_string(Profile profile) {
  return profile == Profile::ideal ? "ideal" : profile == Profile::typical_1 ? "typical@1" : "typical@2";
}

}  // namespace robosim
