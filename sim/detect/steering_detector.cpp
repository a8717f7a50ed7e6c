#include "sim/detect/steering_detector.h"

namespace robosim::detect {

std::string waiting_call(const exec::Activity& activity) {
  for (const char* const name : {"delay", "pulseIn", "print", "write", "flush", "read", "Serial."})
    if (activity.call.starts_with(name)) return activity.call;
  return "";
}

}  // namespace robosim::detect
