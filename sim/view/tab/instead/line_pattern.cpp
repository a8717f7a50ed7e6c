// Replaces RE2: patterns are only used to drive a run step by step, which a tab cannot do.
#include "sim/run/line_pattern.h"

#include "sim/base/error.h"

namespace robosim::run {

LinePattern::LinePattern(const std::string&) {
  throw InputError("a run in a browser's tab cannot wait for a regular expression");
}

bool LinePattern::is_in(const std::string&) const { return false; }

}  // namespace robosim::run
