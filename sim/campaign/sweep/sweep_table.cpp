#include "sim/campaign/sweep/sweep_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>

#include "sim/base/csv.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/campaign/sweep/figures.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

enum Column : std::size_t { kSketch, kMap, kRobot, kTarget, kSeed, kVerdict, kTime };

constexpr const char *kScore = "score", *kCommand = "command";

/// Returns the measurements that have columns of their own, in order. Laps have other columns. The score has
/// a column after `stations`. Junctions, `run_s` and recovered energy have no columns, because
/// existing tables lack them.
const std::vector<Figure>& figure_columns() {
  static const std::vector<Figure> columns = [] {
    std::vector<Figure> chosen;
    for (const Figure& figure : figures()) {
      const std::string_view name = figure.name;
      if (!figure.chip_only && name != "laps_s" && name != "junctions" && name != kScore && name != "run_s" &&
          name != "energy_back_j")
        chosen.push_back(figure);
    }
    return chosen;
  }();
  return columns;
}

std::vector<std::string_view> names_of(Columns columns) {
  std::vector<std::string_view> all{"sketch", "map", "robot", "target", "seed", "verdict"};
  for (const Figure& figure : figure_columns()) all.push_back(figure.name);
  all.insert(all.end(), {"laps", "lap_best_s", "lap_mean_s", "stations", kScore, "stack_bytes_max",
                         "loop_us_max", kCommand, "trace_hash", "inputs", "why"});
  if (columns != Columns::all) std::erase(all, kCommand);
  if (columns == Columns::without_score) std::erase(all, kScore);
  return all;
}

/// Returns the columns of a table with this first line, which includes its line feed if it is complete.
/// Returns nullopt if the line is not a sweep's header.
std::optional<Columns> columns_of(std::string_view line) {
  for (const Columns columns : {Columns::all, Columns::without_command, Columns::without_score})
    if (sweep_header(columns).starts_with(line)) return columns;
  return std::nullopt;
}

std::string_view first_line(std::string_view text) {
  const std::size_t end = text.find('\n');
  return text.substr(0, end == text.npos ? end : end + 1);
}

constexpr std::array<const char*, 4> kParts = {"the sketch's image", "the map", "the robot",
                                               "an option, or the version of Robosim,"};
constexpr std::size_t kGroup = 8;  ///< digits in a group of the field `inputs`; hyphens separate the groups

/// Returns a field without line feeds: each row is one line.
std::string field(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return csv_field(text);
}

template <typename Number>
std::optional<Number> parse_number(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Returns the checksum of a row from its other fields.
std::string seal_of(const std::vector<std::string>& fields) {
  return sha256(fmt::format("{}", fmt::join(fields, "\n"))).substr(0, kGroup);
}

std::string& inputs_field(std::vector<std::string>& fields) { return fields[fields.size() - 2]; }

/// Removes the checksum. Returns false if it does not match; older tables do not have it.
bool take_seal(std::vector<std::string>& fields) {
  std::string& inputs = inputs_field(fields);
  if (inputs.size() == kParts.size() * (kGroup + 1) - 1) return true;
  if (inputs.size() != (kParts.size() + 1) * (kGroup + 1) - 1) return false;
  const std::string seal = inputs.substr(inputs.size() - kGroup);
  inputs.resize(inputs.size() - kGroup - 1);
  return seal == seal_of(fields);
}

/// Parses rows, and finds the run of the plan to which each row belongs.
class Reader {
 public:
  Reader(const std::string& file, const SweepPlan& plan, Columns columns)
      : file_(file), plan_(plan), names_(names_of(columns)), seen_(plan.runs()) {
    for (std::size_t i = 0; i < plan.combinations.size(); ++i) {
      const launch::RunInputs& in = plan.combinations[i].inputs;
      places_.emplace(std::make_tuple(in.sketch, in.map, in.robot, in.target), i);
    }
  }

  SweepRow row(const std::string& line, int number_of_line) {
    line_ = number_of_line;
    auto fields = csv_fields(line);
    if (!fields || fields->size() != names_.size()) fail("expected a row of a sweep's table");
    auto& f = *fields;
    if (!take_seal(f))
      fail("this row is damaged: its checksum does not match; remove the line, and --resume repeats its run");
    const auto seed = parse_number<std::uint64_t>(f[kSeed]);
    const auto time = parse_number<double>(f[kTime]);
    if (!seed || !time || f[kVerdict].empty()) fail("expected a row of a sweep's table");
    const auto place = places_.find(std::make_tuple(f[kSketch], f[kMap], f[kRobot], f[kTarget]));
    if (place == places_.end() || *seed < plan_.first_seed || *seed - plan_.first_seed >= plan_.seeds) {
      fail(fmt::format(
          "this run ({} on {} with {}, target {}, seed {}) is not part of this sweep; continue with "
          "the options that the file was begun with, or name another file",
          f[kSketch], f[kMap], f[kRobot], f[kTarget], *seed));
    }
    const std::string &inputs = f[f.size() - 2], &why = f.back();
    check_inputs(plan_.combinations[place->second], inputs);
    const std::size_t run = place->second * plan_.seeds + (*seed - plan_.first_seed);
    if (seen_[run]) fail("duplicate row: this run already has one");
    seen_[run] = true;
    SweepRow row{run, {f[kVerdict], *time, why}, line + "\n"};
    const auto score = std::find(names_.begin(), names_.end(), kScore);
    if (score != names_.end())
      if (const auto value = parse_number<double>(f[static_cast<std::size_t>(score - names_.begin())]))
        row.outcome.score = *value;
    return row;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError({file_, line_, 0}, message); }

  void check_inputs(const Combination& combination, const std::string& inputs) const {
    if (inputs == combination.fingerprint.text()) return;
    std::size_t at = 0;
    for (std::size_t i = 0; i < kParts.size(); ++i) {
      const std::string& part = combination.fingerprint.parts[i];
      if (inputs.compare(at, part.size(), part) == 0) {
        at += part.size() + 1;
        continue;
      }
      fail(fmt::format("{} has changed since this run; name another file, or undo the change", kParts[i]));
    }
    fail("expected a row of a sweep's table");
  }

  std::string file_;
  const SweepPlan& plan_;
  const std::vector<std::string_view> names_;
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> places_;
  std::vector<bool> seen_;
  int line_ = 0;
};

std::string content_of(const std::vector<SweepRow>& rows, Columns columns) {
  std::string text = sweep_header(columns);
  for (const SweepRow& row : rows) text += row.line;
  return text;
}

[[noreturn]] void refuse_second(const std::string& where, const SweepPlan& plan, std::size_t run) {
  throw InputError(fmt::format("{}: two tables have a row of {}, seed {}; do they belong to the same shard?",
                               where, plan.combination_of(run).text(), plan.seed_of(run)));
}

}  // namespace

std::string sweep_header(Columns columns) { return fmt::format("{}\n", fmt::join(names_of(columns), ",")); }

std::string sweep_row(const Combination& c, const result::RunResult& r, Columns columns) {
  const std::vector<double>& laps = r.metrics.laps_s;
  std::string measured, best, mean, score, stack, loop, command;
  for (const Figure& figure : figure_columns())
    measured += fmt::format("{},", fmt::join(figure.values(r), ""));
  if (!laps.empty()) {
    best = fmt::format("{}", *std::min_element(laps.begin(), laps.end()));
    mean =
        fmt::format("{}", std::accumulate(laps.begin(), laps.end(), 0.0) / static_cast<double>(laps.size()));
  }
  if (columns == Columns::all) command = field(replay_command(c, r.seed)) + ",";
  if (columns != Columns::without_score)
    score = std::isnan(r.metrics.score) ? "," : fmt::format("{},", r.metrics.score);
  if (r.resources) {
    stack = std::to_string(r.resources->stack_bytes_max);
    if (r.resources->loops > 0) loop = fmt::format("{}", r.resources->loop_us_max);
  }
  const std::string begin = fmt::format(
      "{},{},{},{},{},{},{}{},{},{},{},{}{},{},{}{},{}", field(c.inputs.sketch), field(c.inputs.map),
      field(c.inputs.robot), c.inputs.target, r.seed, r.verdict, measured, laps.size(), best, mean,
      r.metrics.stations.size(), score, stack, loop, command, r.trace_hash, c.fingerprint.text());
  const std::string why = field(r.why);
  return fmt::format("{}-{},{}\n", begin, seal_of(*csv_fields(begin + "," + why)), why);
}

std::vector<SweepRow> read_sweep_rows(const std::string& text, const std::string& file,
                                      const SweepPlan& plan) {
  std::vector<SweepRow> rows;
  const auto columns = columns_of(first_line(text));
  if (!columns) throw InputError({file, 1, 0}, "expected the header of a sweep's table; name another file");
  Reader reader(file, plan, *columns);
  int line = 0;
  for (std::size_t at = 0;;) {
    const std::size_t end = text.find('\n', at);
    ++line;
    if (end == std::string::npos) return rows;
    const std::string content = text.substr(at, end - at);
    at = end + 1;
    if (line == 1) continue;
    rows.push_back(reader.row(content, line));
  }
}

std::vector<SweepRow> merged_rows(const std::vector<std::string>& files, const SweepPlan& plan) {
  std::vector<SweepRow> all;
  for (const std::string& file : files) {
    const std::string text = read_file(file);
    std::vector<SweepRow> rows = read_sweep_rows(text, file, plan);
    if (columns_of(first_line(text)) != Columns::all)
      throw InputError({file, 1, 0}, "--merge cannot use a table of an older Robosim");
    for (SweepRow& row : rows)
      if (row.outcome.verdict != kErrorVerdict) all.push_back(std::move(row));
  }
  std::sort(all.begin(), all.end(), [](const SweepRow& a, const SweepRow& b) { return a.run < b.run; });
  const auto twice = std::adjacent_find(all.begin(), all.end(),
                                        [](const SweepRow& a, const SweepRow& b) { return a.run == b.run; });
  if (twice != all.end()) refuse_second("--merge", plan, twice->run);
  return all;
}

SweepTable::SweepTable(fs::path file, bool resume, const SweepPlan& plan, std::vector<SweepOutcome>& outcomes)
    : file_(std::move(file)), plan_(plan) {
  std::error_code error;
  const fs::path& path = file_.path();
  const bool there =
      fs::exists(path, error) && fs::file_size(path, error) > 0 && read_file(path) != sweep_header();
  if (there && !resume)
    throw InputError({path.string(), 0, 0}, "exists already; --resume continues it, or name another file");
  if (!there) {
    file_.begin(sweep_header());
    return;
  }
  const std::string text = read_file(path);
  std::vector<SweepRow> rows = read_sweep_rows(text, path.string(), plan);
  std::erase_if(rows, [](const SweepRow& row) { return row.outcome.verdict == kErrorVerdict; });
  for (const SweepRow& row : rows) {
    outcomes[row.run] = row.outcome;
    ordered_ = ordered_ && row.run >= next_;
    next_ = std::max(next_, row.run + 1);
  }
  columns_ = columns_of(first_line(text)).value_or(Columns::all);
  file_.begin(content_of(rows, columns_));  // without an incomplete row, and without rows of errors
}

void SweepTable::take(const std::vector<SweepRow>& rows, std::vector<SweepOutcome>& outcomes) {
  if (!rows.empty() && columns_ != Columns::all)
    throw InputError({file_.path().string(), 1, 0},
                     "lacks columns that the tables of --merge have; name another file");
  for (const SweepRow& row : rows) {
    if (outcomes[row.run].made()) refuse_second(file_.path().string(), plan_, row.run);
    outcomes[row.run] = row.outcome;
    add(row.run, row.line);
  }
}

void SweepTable::add(std::size_t run, const std::string& row) {
  file_.append(row);
  ordered_ = ordered_ && run >= next_;
  next_ = std::max(next_, run + 1);
}

void SweepTable::finish() {
  if (ordered_) return;
  std::vector<SweepRow> rows = read_sweep_rows(read_file(file_.path()), file_.path().string(), plan_);
  std::sort(rows.begin(), rows.end(), [](const SweepRow& a, const SweepRow& b) { return a.run < b.run; });
  write_file(file_.path(), content_of(rows, columns_));
}

}  // namespace robosim::campaign
