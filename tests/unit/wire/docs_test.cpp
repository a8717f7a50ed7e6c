// Tests that the tables of keys in docs/ equal the messages' descriptions. A table is between `<!-- keys of
// NAME -->` and `<!-- end of keys -->`. To regenerate the tables, run `ROBOSIM_WRITE_DOCS=1 wire_test
// --gtest_filter='Docs.*'`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "sim/base/file.h"
#include "sim/result/detector_names.h"
#include "sim/wire/json_writer.h"
#include "sim/wire/live.h"
#include "sim/wire/messages.h"

namespace robosim::wire {
namespace docs_test {

namespace fs = std::filesystem;

/// Writes a message's keys as a Markdown table.
class TableWriter {
 public:
  static constexpr bool kReads = false;
  static constexpr bool kDescribes = true;

  /// Begins a table. The table of a request has an additional column: the meaning of a missing key.
  explicit TableWriter(bool request) : request_(request) {
    text = request ? "| key | value | meaning | default |\n|---|---|---|---|\n"
                   : "| key | value | meaning |\n|---|---|---|\n";
  }

  template <class T>
  void operator()(const char* key, T&& value, const char* meaning, const Rules& rules = {}) {
    row(key, kind_of<std::remove_cvref_t<T>>(rules), meaning, default_of(value, rules));
  }

  template <class Kind, class T>
  void choice(Kind, Kind, const char* key, const T&, const char* meaning, const Rules& rules = {}) {
    row(key, kind_of<T>(rules), meaning, "one of these");
  }

  template <class... What>
  void kinds(const char* key, const std::optional<std::variant<What...>>&, const char* meaning) {
    std::string names;
    ((names += (names.empty() ? "`\"" : ", `\"") + std::string(What::kKind) + "\"`"), ...);
    row(key, names, meaning, "");
    (add(What{}), ...);
  }

  std::string text;

 private:
  template <class T>
  void add(const T& message) {
    fields(*this, message);
  }

  void row(const char* key, std::string kind, const char* meaning, const std::string& absent) {
    text += "| `" + std::string(key) + "` | " + kind + " | " + meaning;
    text += request_ ? " | " + absent + " |\n" : " |\n";
  }

  template <class T>
  static std::string kind_of(const Rules& rules) {
    const std::string unit = *rules.unit ? std::string(", ") + rules.unit : "";
    if constexpr (detail::IsOptional<T>::value)
      return kind_of<typename T::value_type>(rules);
    else if constexpr (std::is_same_v<T, bool>)
      return "`true` or `false`";
    else if constexpr (std::is_integral_v<T>)
      return "whole number" + unit;
    else if constexpr (std::is_floating_point_v<T>)
      return "number" + unit;
    else if constexpr (std::is_same_v<T, std::string>)
      return words(rules);
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      return "array of numbers" + unit;
    else if constexpr (std::is_same_v<T, std::vector<std::string>>)
      return "array of strings";
    else if constexpr (detail::IsVector<T>::value)
      return detail::Tuple<typename T::value_type> ? "array of arrays" + unit : "array of objects";
    else if constexpr (detail::IsNameList<T>::value)
      return "array of strings";
    else if constexpr (detail::Tuple<T>)
      return "array of " + std::to_string(std::tuple_size_v<T>) + unit;
    else
      return "object";
  }

  static std::string words(const Rules& rules) {
    std::string text;
    for (const char* word : rules.one_of)
      text += (text.empty() ? "`\"" : ", `\"") + std::string(word) + "\"`";
    return text.empty() ? "string" : text;
  }

  template <class T>
  std::string default_of(const T& value, const Rules& rules) const {
    if (!request_) return "";
    if (*rules.otherwise) return rules.otherwise;
    if (detail::IsOptional<T>::value || !rules.presence.required) {
      if constexpr (!detail::IsOptional<T>::value && !detail::IsNameList<T>::value)
        return "`" + text_of(JsonWriter<OrderedJson>::json(value)) + "`";
    }
    return "required";
  }

  bool request_;
};

struct Table {
  std::string name;
  std::string text;
};

template <class T>
Table table(const char* name, bool request = false) {
  TableWriter writer(request);
  const T message{};
  fields(writer, message);
  return {name, writer.text};
}

/// Returns the table of all detectors.
Table detectors() {
  std::string text = "| detector | targets | finding |\n|---|---|---|\n";
  for (const result::DetectorName& one : result::kDetectorNames)
    text.append("| `").append(one.name).append("` | ").append(one.targets).append(" | ").append(one.finds) +=
        " |\n";
  return {"detectors", text};
}

std::vector<Table> tables() {
  return {table<DescribeRobot>("describe_robot", true),
          table<RunRequest>("run", true),
          table<AgentRequest>("run.agents", true),
          table<Lateness>("run.late", true),
          table<Ways>("run.ways", true),
          table<Act>("script", true),
          table<GoOn>("continue", true),
          table<Stop>("stop", true),
          table<Play>("play", true),
          table<StepOn>("step", true),
          table<Hello>("hello"),
          table<ErrorAnswer>("error"),
          table<RobotInfo>("robot"),
          table<RobotInfo::Board>("robot.board"),
          table<RobotInfo::Budget>("robot.budget"),
          table<RobotInfo::Sensor>("robot.sensors"),
          table<RobotInfo::Steering>("robot.steering"),
          table<RobotInfo::Gauge>("robot.gauges"),
          table<RobotInfo::Part>("robot.parts"),
          table<Started>("started"),
          table<Started::Station>("started.stations"),
          table<Sample>("sample"),
          table<PinChange>("pin"),
          table<LevelSeen>("level"),
          table<VoltsSeen>("volts"),
          table<SerialByte>("byte"),
          table<SerialText>("serial"),
          table<Note>("note"),
          table<PowerLost::HalfWritten>("note.byte"),
          table<DebuggerAwaited>("debugger_awaited"),
          table<Columns>("columns"),
          table<Rows>("columns.streams"),
          table<ColumnSpec>("columns.streams.columns"),
          table<Batch>("batch"),
          table<SourceLine>("source"),
          table<RunResult>("result"),
          table<Metrics>("metrics"),
          table<Crash>("crash"),
          table<DivisionByZero>("divisions_by_zero"),
          table<Lack>("lacks"),
          table<Detected>("detected"),
          table<Resources>("resources"),
          table<Usage>("usage"),
          table<Usage::Loose>("usage.unwired"),
          table<Usage::Steady>("usage.steady"),
          table<RunResult::Entry>("result.events"),
          table<Pose>("result.end"),
          table<Paused>("paused"),
          table<Worst>("paused.worst"),
          table<Accepted>("accepted"),
          detectors()};
}

constexpr const char* kBegin = "<!-- keys of ";
constexpr const char* kEnd = "<!-- end of keys -->";

/// Returns the page with up-to-date tables. Adds the names of the page's tables to `found`.
std::string brought_up_to_date(const std::string& page, const std::vector<Table>& all,
                               std::multiset<std::string>& found) {
  std::string text;
  std::size_t at = 0;
  for (std::size_t begin; (begin = page.find(kBegin, at)) != std::string::npos;) {
    const std::size_t name = begin + std::string(kBegin).size();
    const std::size_t name_end = page.find(" -->", name);
    const std::size_t end = page.find(kEnd, name_end);
    if (end == std::string::npos) throw std::runtime_error("a table of keys has no end");
    const std::string which = page.substr(name, name_end - name);
    const auto described =
        std::find_if(all.begin(), all.end(), [&](const Table& each) { return each.name == which; });
    if (described == all.end()) throw std::runtime_error("there are no keys of " + which);
    found.insert(which);
    text += page.substr(at, name_end - at) + " -->\n\n" + described->text + "\n";
    at = end;
  }
  return text + page.substr(at);
}

TEST(Docs, TablesOfKeysSayWhatTheDescriptionsSay) {
  const bool write = std::getenv("ROBOSIM_WRITE_DOCS") != nullptr;
  const std::vector<Table> all = tables();
  std::multiset<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROBOSIM_SOURCE_DIR) / "docs")) {
    if (entry.path().extension() != ".md") continue;
    const std::string page = read_file(entry.path());
    const std::string wanted = brought_up_to_date(page, all, found);
    if (write && page != wanted) write_file(entry.path(), wanted);
    EXPECT_TRUE(write || page == wanted)
        << entry.path() << ": regenerate its tables with ROBOSIM_WRITE_DOCS=1 and this test";
  }
  for (const Table& each : all)
    EXPECT_EQ(found.count(each.name), 1u) << "docs/ has one table of the keys of " << each.name;
}

}  // namespace docs_test
}  // namespace robosim::wire
