// Without RE2: only who drives a run step by step waits for patterns, and nobody does in a tab.
#include "sim/run/line_pattern.h"

#include "sim/base/error.h"

namespace robosim::run {

LinePattern::LinePattern(const std::string&) {
  throw InputError("a run in a browser's tab cannot wait for a regular expression");
}

bool LinePattern::is_in(const std::string&) const { return false; }

}  // namespace robosim::run
