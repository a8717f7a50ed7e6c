// Replaces RE2: only drivers of a run step by step wait for patterns, and a tab has none.
#include "sim/run/line_pattern.h"

#include "sim/base/error.h"

namespace robosim::run {

LinePattern::LinePattern(const std::string&) {
  throw InputError("a run in a browser's tab cannot wait for a regular expression");
}

bool LinePattern::is_in(const std::string&) const { return false; }

}  // namespace robosim::run
