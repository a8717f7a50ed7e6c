#include "sim/record/recording.h"

#include <algorithm>
#include <cmath>

#include "sim/base/file.h"
#include "sim/record/record_page.h"
#include "sim/wire/json_reader.h"

namespace robosim::record {
namespace {

constexpr std::size_t kMostInflated_bytes = std::size_t{1} << 30;

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
  throw InputError({file}, "this is no recording that can be read: " + problem);
}

}  // namespace

void Gatherer::encode(const wire::RunResult& result, const Put& put) {
  std::vector<const KeptBytes*> body;
  put(kRecordingMagic);
  Compressed compressed(put);
  compressed.add(finish(result, body));
  for (const KeptBytes* bytes : body) compressed.add(*bytes);
  compressed.finish();
}

std::string Gatherer::encoded(const wire::RunResult& result) {
  std::string all;
  encode(result, [&all](std::string_view piece) { all += piece; });
  return all;
}

Recording Recording::read(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::string content = read_file(file);
  try {
    return decode(recording_in(std::move(content)), name);
  } catch (const InputError& error) {
    if (!error.place().file.empty()) throw;
    refuse(name, error.message());
  }
}

Recording Recording::decode(std::string_view bytes, const std::string& file) {
  const std::string_view magic = kRecordingMagic;
  if (!bytes.starts_with(magic)) {
    if (is_recording(bytes))
      refuse(file, "it is of a newer version of Robosim, " +
                       wire::excerpt(bytes.substr(0, std::min(bytes.find('\n'), std::size_t{40}))));
    refuse(file, "it does not begin as one");
  }
  Recording recording;
  recording.file_ = file;
  try {
    const std::string all = inflated(bytes.substr(magic.size()), kMostInflated_bytes);
    const std::size_t end = all.find('\n');
    const auto json = wire::JsonReader::Json::parse(all.substr(0, end), nullptr, false);
    if (end == std::string::npos || json.is_discarded()) throw InputError("its header is damaged");
    wire::JsonReader::read(json, recording.header_, wire::JsonReader::Unknown::allowed);
    recording.body_ = all.substr(end + 1);
  } catch (const wire::BadValue& bad) {
    refuse(file, bad.in("its header"));
  } catch (const InputError& error) {
    refuse(file, error.message());
  }
  std::size_t total = 0;
  for (std::size_t robot = 0; robot < recording.header_.robot_count(); ++robot) {
    for (const StreamInfo& stream : recording.header_.of(robot).streams) {
      for (const ColumnInfo& column : stream.columns) {
        if (static_cast<std::size_t>(column.bytes) > recording.body_.size() - total || !(column.scale > 0.0))
          refuse(file, "its column " + column.name + " is longer than the file");
        total += static_cast<std::size_t>(column.bytes);
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

std::vector<std::vector<std::int64_t>> Recording::steps(const std::string& name, std::size_t robot) const {
  std::vector<std::vector<std::int64_t>> columns;
  each_column(robot, name, [&](const ColumnInfo& column, std::string_view bytes, std::size_t count) {
    if (column.order == 0) return;
    auto steps = wire::ColumnReader(column.order).read(bytes, count);
    if (!steps) refuse(file_, "its column " + column.name + " is damaged");
    columns.push_back(std::move(*steps));
  });
  return columns;
}

std::vector<std::vector<double>> Recording::stream(const std::string& name, std::size_t robot) const {
  std::vector<std::vector<double>> columns;
  for (const auto& steps : this->steps(name, robot)) columns.emplace_back(steps.begin(), steps.end());
  std::size_t next = 0;
  each_column(robot, name, [&](const ColumnInfo& column, std::string_view, std::size_t) {
    if (column.order == 0) return;
    for (double& value : columns[next]) value /= column.scale;
    ++next;
  });
  return columns;
}

void Recording::play(const wire::OnEvent& on_event) const {
  struct Timed {
    std::int64_t t_ns;
    wire::Event event;
  };
  std::vector<Timed> events;
  for (const wire::Note& note : header_.notes) events.push_back({note.t_ns, note});

  for (std::size_t robot = 0; robot < header_.robot_count(); ++robot) {
    const int agent = static_cast<int>(robot);
    const auto samples = stream("samples", robot);
    constexpr std::size_t kFixed = 10;
    for (std::size_t i = 0; samples.size() >= kFixed && i < samples[0].size(); ++i) {
      const auto at = [&](std::size_t column) { return samples[column][i]; };
      wire::Sample s{std::llround(at(0)), at(1), at(2), at(3), at(4), at(5), at(6), at(7), {}, "",
                     {at(8), at(9)},      agent};
      for (std::size_t column = kFixed; column < samples.size(); ++column) s.readings.push_back(at(column));
      const std::int64_t t_ns = s.t_us * 1000;
      events.push_back({t_ns, std::move(s)});
    }

    const auto serial = stream("serial", robot);
    std::string_view text;
    each_column(robot, "serial", [&](const ColumnInfo& column, std::string_view bytes, std::size_t) {
      if (column.order == 0) text = bytes;
    });
    for (std::size_t i = 0; serial.size() >= 2 && i < serial[0].size(); ++i) {
      const auto bytes = static_cast<std::size_t>(std::clamp(serial[1][i], 0.0, 1.0 * text.size()));
      const std::int64_t t_ns = std::llround(serial[0][i]);
      events.push_back({t_ns, wire::SerialText{t_ns, std::string(text.substr(0, bytes)), agent}});
      text.remove_prefix(bytes);
    }
  }

  std::stable_sort(events.begin(), events.end(),
                   [](const Timed& a, const Timed& b) { return a.t_ns < b.t_ns; });
  for (std::size_t robot = 0; robot < header_.robot_count(); ++robot) on_event(header_.of(robot).started);
  for (const Timed& timed : events) on_event(timed.event);
}

}  // namespace robosim::record
