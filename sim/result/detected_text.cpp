// Converts the finding of a detector to sentences (run_result.h).
#include <fmt/format.h>

#include "sim/result/run_result.h"

namespace robosim::result {

std::string text_of(const Detected& seen) {
  const SourceLine& where = seen.where;
  const std::string place =
      where.file.empty() ? ""
                         : fmt::format("{}, {}:{}", where.function.empty() ? "" : " in " + where.function,
                                       where.file, where.line);
  return fmt::format("{}{} ({}{:.2f} s). {}", seen.what, place,
                     seen.times == 1 ? "at " : fmt::format("{} times, first at ", seen.times), seen.first_s,
                     seen.mend);
}

}  // namespace robosim::result
