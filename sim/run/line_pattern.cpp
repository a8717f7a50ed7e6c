#include "sim/run/line_pattern.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include "sim/base/error.h"

namespace robosim::run {

LinePattern::LinePattern(const std::string& text) {
  re2::RE2::Options options;
  options.set_encoding(re2::RE2::Options::EncodingLatin1);
  options.set_log_errors(false);
  auto expression = std::make_shared<const re2::RE2>(text, options);
  if (!expression->ok())
    throw InputError(fmt::format(
        "invalid regular expression \"{}\": expected one that runs in linear time (ECMAScript's without "
        "lookahead and back references); {}",
        text, expression->error()));
  expression_ = std::move(expression);
}

bool LinePattern::is_in(const std::string& line) const { return re2::RE2::PartialMatch(line, *expression_); }

}  // namespace robosim::run
