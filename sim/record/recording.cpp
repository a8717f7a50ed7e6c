#include "sim/record/recording.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/record/record_page.h"
#include "sim/wire/json_parse.h"
#include "sim/wire/json_reader.h"

namespace robosim::record {
namespace {

// Gatherer's recordings stay far below these limits: an hour of one robot has 5 million numbers.
constexpr std::size_t kMostRecording_bytes = std::size_t{64} << 20;  // size of a .rec or a page
constexpr std::size_t kBeginning_bytes = std::size_t{64} << 10;      // enough to detect the kind of the file
constexpr std::size_t kMostHeader_bytes = std::size_t{16} << 20;
constexpr std::size_t kMostBody_bytes = std::size_t{64} << 20;
constexpr std::uint64_t kMostNumbers = 16'000'000;

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
  throw InputError({file}, "not a readable recording: " + problem);
}

void append(std::string& to, std::string_view piece, std::size_t most_bytes) {
  if (piece.size() > most_bytes - to.size()) throw InputError("its content is too large");
  to += piece;
}

RecordingHeader header_of(std::string_view line) {
  const wire::JsonReader::Json json = wire::parsed_json(line);
  if (json.is_discarded()) throw InputError("its header is damaged");
  RecordingHeader header;
  wire::JsonReader::read(json, header, wire::JsonReader::Unknown::allowed);
  if (header.robot_count() > result::kMostAgents) throw InputError("it has too many robots");
  return header;
}

}  // namespace

void Gatherer::encode(const result::RunResult& result, const Put& put) {
  std::vector<const CompressedBytes*> body;
  put(kRecordingMagic);
  Compressed compressed(put);
  compressed.add(finish(result, body));
  for (const CompressedBytes* bytes : body) compressed.add(*bytes);
  compressed.finish();
}

std::string Gatherer::encoded(const result::RunResult& result) {
  std::string all;
  encode(result, [&all](std::string_view piece) { all += piece; });
  return all;
}

Recording Recording::read(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::string content = read_file(file, kMostRecording_bytes);
  const std::string beginning = content.substr(0, kBeginning_bytes);
  try {
    return decode(recording_in(std::move(content)), name);
  } catch (const InputError& error) {
    refuse_other_kind(beginning, FileKind::recording, name);
    if (!error.place().file.empty()) throw;
    refuse(name, error.message());
  }
}

Recording Recording::decode(std::string_view bytes, const std::string& file) {
  const std::string_view magic = kRecordingMagic;
  if (!bytes.starts_with(magic)) {
    if (is_recording(bytes))
      refuse(file, "it was made by a newer version of Robosim, " +
                       wire::excerpt(bytes.substr(0, std::min(bytes.find('\n'), std::size_t{40}))));
    refuse(file, "it does not begin like a recording");
  }
  Recording recording;
  recording.file_ = file;
  try {
    std::string line;
    bool has_header = false;
    inflate(bytes.substr(magic.size()), [&](std::string_view piece) {
      if (!has_header) {
        const std::size_t end = std::min(piece.find('\n'), piece.size());
        append(line, piece.substr(0, end), kMostHeader_bytes);
        if (end == piece.size()) return;
        recording.header_ = header_of(std::exchange(line, {}));
        has_header = true;
        piece.remove_prefix(end + 1);
      }
      append(recording.body_, piece, kMostBody_bytes);
    });
    if (!has_header) throw InputError("its header is damaged");
  } catch (const wire::BadValue& bad) {
    refuse(file, bad.in("its header"));
  } catch (const InputError& error) {
    refuse(file, error.message());
  }
  std::size_t total = 0;
  std::uint64_t numbers = 0;
  for (std::size_t robot = 0; robot < recording.header_.robot_count(); ++robot) {
    std::set<std::string> names;
    for (const StreamInfo& stream : recording.header_.of(robot).streams) {
      if (!names.insert(stream.name).second)
        refuse(file, "it has two streams of the name " + wire::excerpt(stream.name));
      for (const ColumnInfo& column : stream.columns) {
        if (static_cast<std::size_t>(column.bytes) > recording.body_.size() - total || !(column.scale > 0.0))
          refuse(file, "its column " + column.name + " is longer than the file");
        total += static_cast<std::size_t>(column.bytes);
        numbers += column.order == 0 ? 0 : static_cast<std::uint64_t>(stream.count);
        if (numbers > kMostNumbers) refuse(file, "it has too many numbers");
      }
    }
  }
  return recording;
}

template <class Visit>
void Recording::each_column(std::size_t robot, const std::string& stream_name, Visit visit) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i <= robot && i < header_.robot_count(); ++i) {
    for (const StreamInfo& stream : header_.of(i).streams) {
      for (const ColumnInfo& column : stream.columns) {
        const auto size = static_cast<std::size_t>(column.bytes);
        if (i == robot && stream.name == stream_name)
          visit(column, std::string_view(body_).substr(at, size), static_cast<std::size_t>(stream.count));
        at += size;
      }
    }
  }
}

template <class Take>
void Recording::each_steps(std::size_t robot, const std::string& name, Take take) const {
  each_column(robot, name, [&](const ColumnInfo& column, std::string_view bytes, std::size_t count) {
    if (column.order == 0) return;
    auto steps = wire::ColumnReader(column.order).read(bytes, count);
    if (!steps) refuse(file_, "its column " + column.name + " is damaged");
    take(column, std::move(*steps));
  });
}

std::vector<std::vector<std::int64_t>> Recording::steps(const std::string& name, std::size_t robot) const {
  std::vector<std::vector<std::int64_t>> columns;
  each_steps(robot, name, [&](const ColumnInfo&, std::vector<std::int64_t> steps) {
    columns.push_back(std::move(steps));
  });
  return columns;
}

std::vector<std::vector<double>> Recording::stream(const std::string& name, std::size_t robot) const {
  std::vector<std::vector<double>> columns;
  each_steps(robot, name, [&](const ColumnInfo& column, const std::vector<std::int64_t>& steps) {
    std::vector<double>& values = columns.emplace_back(steps.begin(), steps.end());
    for (double& value : values) value /= column.scale;
  });
  return columns;
}

void Recording::play(const wire::OnEvent& on_event) const {
  constexpr std::size_t kFixed = 10;
  struct Robot {
    std::vector<std::vector<double>> samples, serial;
    std::string_view text;  // text of the serial rows that have not been reported yet
  };
  std::vector<Robot> robots(header_.robot_count());
  // The source of an event is 0 (a note), 2 n + 1 (a sample of robot n) or 2 n + 2 (its serial text). Events
  // with equal times keep this order.
  struct Timed {
    std::uint32_t source, index;
  };
  std::vector<Timed> events;
  const auto add = [&](std::size_t source, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      events.push_back({static_cast<std::uint32_t>(source), static_cast<std::uint32_t>(i)});
  };
  std::size_t count = header_.notes.size();
  for (std::size_t n = 0; n < robots.size(); ++n) {
    Robot& robot = robots[n];
    robot.samples = stream("samples", n);
    robot.serial = stream("serial", n);
    if (robot.samples.size() < kFixed) robot.samples.assign(kFixed, {});
    if (robot.serial.size() < 2) robot.serial.assign(2, {});
    each_column(n, "serial", [&](const ColumnInfo& column, std::string_view bytes, std::size_t) {
      if (column.order == 0) robot.text = bytes;
    });
    count += robot.samples[0].size() + robot.serial[0].size();
  }
  events.reserve(count);
  add(0, header_.notes.size());
  for (std::size_t n = 0; n < robots.size(); ++n) {
    add(2 * n + 1, robots[n].samples[0].size());
    add(2 * n + 2, robots[n].serial[0].size());
  }
  const auto time_of = [&](const Timed& event) -> std::int64_t {
    if (event.source == 0) return header_.notes[event.index].t_ns;
    const Robot& robot = robots[(event.source - 1) / 2];
    if (event.source % 2 == 0) return std::llround(robot.serial[0][event.index]);
    return std::llround(robot.samples[0][event.index]) * 1000;
  };
  std::stable_sort(events.begin(), events.end(),
                   [&](const Timed& a, const Timed& b) { return time_of(a) < time_of(b); });

  for (std::size_t robot = 0; robot < robots.size(); ++robot) on_event(header_.of(robot).started);
  for (const Timed& event : events) {
    const std::size_t i = event.index;
    if (event.source == 0) {
      on_event(header_.notes[i]);
      continue;
    }
    const std::size_t n = (event.source - 1) / 2;
    const int agent = static_cast<int>(n);
    Robot& robot = robots[n];
    if (event.source % 2 == 0) {
      const auto bytes =
          static_cast<std::size_t>(std::clamp(robot.serial[1][i], 0.0, 1.0 * robot.text.size()));
      on_event(wire::SerialText{time_of(event), std::string(robot.text.substr(0, bytes)), agent});
      robot.text.remove_prefix(bytes);
      continue;
    }
    const auto at = [&](std::size_t column) { return robot.samples[column][i]; };
    wire::Sample s{std::llround(at(0)), at(1), at(2), at(3), at(4), at(5), at(6), at(7), {}, "",
                   {at(8), at(9)},      agent};
    for (std::size_t column = kFixed; column < robot.samples.size(); ++column)
      s.readings.push_back(at(column));
    on_event(s);
  }
}

}  // namespace robosim::record
