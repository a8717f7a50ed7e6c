// Replaces the regular expressions of RE2. Only a run that is driven step by step uses them, and a tab has no
// such runs.
#include "sim/run/line_pattern.h"

#include "sim/base/error.h"

namespace robosim::run {

LinePattern::LinePattern(const std::string&) {
  throw InputError("a run in a browser's tab cannot wait for a regular expression");
}

bool LinePattern::is_in(const std::string&) const { return false; }

}  // namespace robosim::run
