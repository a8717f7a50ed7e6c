#include "sim/campaign/calibrate/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "sim/base/csv.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace robosim::calibrate {
namespace {

constexpr const char* kBegins = "# robosim calibration log";
constexpr std::size_t kLeastSweep = 100, kLeastDrive = 10;  // minimum number of rows
constexpr std::size_t kMostRows = 200'000;
constexpr double kMostReading = 100'000.0;  // us, limit for RC sensors; ADC codes have another (1023)

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Removes the time that Arduino's serial monitor prints before each line.
std::string_view without_stamp(std::string_view line) {
  const std::size_t arrow = line.find(" -> ");
  if (arrow == line.npos || arrow > 16 || line.find(':') > arrow) return line;
  return line.substr(arrow + 4);
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string shortened(std::string_view text) {
  return std::string(text.substr(0, 40)) + (text.size() > 40 ? " …" : "");
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(without_byte_order_mark(text)) {
    log_.file = file;
  }

  Log read() {
    if (text_.find_first_not_of(" \t\r\n") == text_.npos)
      throw InputError({log_.file}, "the log is empty: expected the output of the sketch CalibrationLogger");
    refuse_bytes();
    const int first = first_line();
    for (std::size_t begin = 0; begin < text_.size();) {
      std::size_t end = std::min(text_.find('\n', begin), text_.size());
      ++line_;
      std::string_view line = text_.substr(begin, end - begin);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line_ >= first) take(trimmed(without_stamp(line)));
      begin = end + 1;
    }
    finish_table();
    if (log_.sweeps.empty() && log_.drives.empty())
      throw InputError(
          {log_.file},
          "the log has no table: expected a line that begins with t_us, the first column's name");
    return std::move(log_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError({log_.file, line_}, message); }

  void refuse_bytes() const {
    int line = 1;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      const bool ends = c == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
      const auto byte = static_cast<unsigned char>(c);
      if (c == '\n') ++line;
      if ((byte < 32 && c != '\n' && c != '\t' && !ends) || byte == 127)
        throw InputError({log_.file, line}, fmt::format("not a log: expected text, as CalibrationLogger "
                                                        "prints it, got a byte 0x{:02X}",
                                                        byte));
    }
  }

  int first_line() const {
    const std::size_t last = text_.rfind(kBegins);
    if (last == text_.npos) return 1;
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<long>(last), '\n'));
  }

  void take(std::string_view line) {
    if (line.empty()) return;
    if (line.front() == '#') return setting(trimmed(line.substr(1)));
    const auto fields = csv_fields(line);
    if (!fields) fail("a quote is never closed: expected a row of numbers separated by commas");
    if (trimmed(fields->front()) == "t_us") return begin_table(*fields);
    row(*fields);
  }

  void setting(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view key = trimmed(text.substr(0, equals));
    if (equals == text.npos || (key != "counts_per_period" && key != "timing_step_us")) return;
    const std::string_view text_of_it = trimmed(text.substr(equals + 1));
    const auto value = number(text_of_it);
    const auto refuse = [&](const char* allowed) {
      fail(fmt::format("{}: expected {}, got “{}”", key, allowed, shortened(text_of_it)));
    };
    if (key == "timing_step_us") {
      if (!value || !(*value > 0.0 && *value <= 1000.0)) refuse("a number of microseconds up to 1000");
      log_.timing_step = 1e-6 * *value;
    } else {
      if (!value || (*value != 1.0 && *value != 2.0 && *value != 4.0)) refuse("1, 2 or 4");
      log_.counts_per_period = value;
    }
  }

  void begin_table(const std::vector<std::string>& fields) {
    finish_table();
    table_line_ = line_;
    names_.clear();
    for (const std::string& field : fields) {
      const std::string name(trimmed(field));
      if (name.empty()) fail("a column without a name");
      if (std::find(names_.begin(), names_.end(), name) != names_.end())
        fail(fmt::format("the column {} is given twice", shortened(name)));
      names_.push_back(name);
    }
    columns_.assign(names_.size(), {});
    lines_.clear();
    const bool left = has("left"), right = has("right");
    const bool counts_left = has("count_left"), counts_right = has("count_right");
    is_drive_ = left || right;
    if (left != right) fail(fmt::format("the column {} is missing", left ? "right" : "left"));
    if (counts_left != counts_right)
      fail(fmt::format("the column {} is missing", counts_left ? "count_right" : "count_left"));
    if (is_drive_ && !counts_left)
      fail(
          "a drive requires the columns count_left and count_right; without encoders, use a stopwatch: "
          "docs/howto/calibrating.md");
    if (!is_drive_ && names_.size() < (counts_left ? 4u : 2u))
      fail(
          "a sweep without a sensor: expected the columns t_us, optionally count_left and count_right, and "
          "at least one sensor of the robot");
    if (is_drive_ && names_.size() > 5)
      fail("too many columns for a drive: expected t_us, left, right, count_left and count_right");
  }

  bool has(const char* name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

  void row(const std::vector<std::string>& fields) {
    if (names_.empty())
      fail(fmt::format("a row before the column names: expected a first row that begins with t_us, got “{}”",
                       shortened(fields.front())));
    if (fields.size() != names_.size())
      fail(fmt::format("expected {} fields, one for each column name on line {}, got {}", names_.size(),
                       table_line_, fields.size()));
    if (lines_.size() >= kMostRows)
      fail(fmt::format("the table has too many rows: expected at most {}", kMostRows));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string_view field = trimmed(fields[i]);
      const auto value = number(field);
      if (!value) fail(fmt::format("{}: expected a number, got “{}”", names_[i], shortened(field)));
      if (!std::isfinite(*value))
        fail(fmt::format("{}: expected a finite number, got {}", names_[i], *value));
      check(names_[i], *value);
      columns_[i].push_back(*value);
    }
    lines_.push_back(line_);
  }

  void check(const std::string& name, double value) const {
    if (name == "t_us") {
      const auto& times = columns_[static_cast<std::size_t>(place_of("t_us"))];
      if (!times.empty() && value <= times.back())
        fail(fmt::format("t_us: expected a later time than {} in the row before, got {}", times.back(),
                         value));
      if (value < 0.0 || value > 4.3e9)
        fail(fmt::format("t_us: expected a number from 0 to 4.3e9, got {}", value));
    } else if (name == "left" || name == "right") {
      if (std::fabs(value) > 255.0 || value != std::floor(value))
        fail(fmt::format("{}: expected a whole number from -255 to 255, got {}", name, value));
    } else if (name == "count_left" || name == "count_right") {
      if (std::fabs(value) > 1e9)
        fail(fmt::format("{}: expected a number from -1e9 to 1e9, got {}", name, value));
    } else if (value < 0.0 || value > kMostReading) {
      fail(fmt::format("{}: expected a reading from 0 to 1023, or of an RC sensor in microseconds, got {}",
                       name, value));
    }
  }

  long place_of(const char* name) const {
    return std::find(names_.begin(), names_.end(), name) - names_.begin();
  }

  void finish_table() {
    if (names_.empty()) return;
    const std::size_t least = is_drive_ ? kLeastDrive : kLeastSweep;
    if (lines_.size() < least)
      throw InputError({log_.file, table_line_},
                       fmt::format("the {} is too short: expected at least {} rows, got {}",
                                   is_drive_ ? "drive" : "sweep", least, lines_.size()));
    const auto column = [&](const char* name) { return columns_[static_cast<std::size_t>(place_of(name))]; };
    std::vector<double> t = column("t_us");
    for (double& time : t) time *= 1e-6;
    if (is_drive_) {
      Drive drive{table_line_, lines_, std::move(t), {}, {column("count_left"), column("count_right")}};
      for (const int side : {0, 1})
        for (const double told : column(side == 0 ? "left" : "right"))
          drive.told[static_cast<std::size_t>(side)].push_back(static_cast<int>(told));
      log_.drives.push_back(std::move(drive));
    } else {
      Sweep sweep{table_line_, lines_, std::move(t), has("count_left"), {}, {}, {}};
      if (sweep.counted) sweep.count = {column("count_left"), column("count_right")};
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i] == "t_us" || names_[i] == "count_left" || names_[i] == "count_right") continue;
        sweep.names.push_back(names_[i]);
        sweep.readings.push_back(columns_[i]);
      }
      log_.sweeps.push_back(std::move(sweep));
    }
    names_.clear();
  }

  const std::string_view text_;
  Log log_;
  int line_ = 0, table_line_ = 0;
  bool is_drive_ = false;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::vector<int> lines_;
};

}  // namespace

Log parse_log(std::string_view text, const std::string& file) { return Reader(text, file).read(); }

}  // namespace robosim::calibrate
