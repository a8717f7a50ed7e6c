#include "sim/wire/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace batch_test {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string line_of(const Event& event) { return to_line(Id(std::int64_t{1}), Answer(event)); }

/// Returns the bytes of a batch. They follow the batch's line, which must contain their number.
std::string bytes_in(const std::string& said) {
  const std::size_t end = said.find('\n') + 1;
  const Line line = parse_line(said.substr(0, end));
  EXPECT_EQ(std::get<Batch>(std::get<Event>(line.content)).size,
            std::ssize(said) - std::ssize(said.substr(0, end)));
  return said.substr(end);
}

RunRequest of_all() {
  RunRequest request;
  request.batches = request.pins = request.io = true;
  request.samples_every_ns = 10'000'000;
  return request;
}

std::vector<std::string> told(BatchReader& reader, const std::string& bytes) {
  std::vector<std::string> lines;
  reader.read(bytes, [&](const Event& event) { lines.push_back(line_of(event)); });
  return lines;
}

constexpr double kThird = 0.1 + 0.2, kSmallest = std::numeric_limits<double>::denorm_min();

/// Adds all events that a batch supports, with extreme values. Returns the expected lines.
std::vector<std::string> add_all(BatchWriter& writer) {
  const std::vector<Event> events = {
      Sample{kLatest_ns / 1000, kThird, -0.0, -1e308, kSmallest, 5, 6, 7, {kThird, 0, 1023}, "", {8, 9}, 255},
      Sample{},
      PinChange{7, "D5", "output", true, true, kThird, 4'000'000'000, {}, 0},
      PinChange{8, "", "input_pullup", false, false, 0, 0, {}, 1},
      LevelSeen{kLatest_ns, "PC13", true, {}, 2},
      VoltsSeen{0, "A0", kThird, {}, 3},
      PinChange{8, "D5", "output", false, false, 0, 0, {}, 0},
      SerialByte{9, 0, true, {}, 4},
      SerialByte{9, 255, false, {}, 255}};
  writer.add(events[0]);
  writer.add(events[1]);
  writer.add_pin(0, 7, 5, "D5", 2, true, true, kThird, 4'000'000'000, 0);
  writer.add_pin(1, 8, 255, "", 1, false, false, 0, 0, 0);
  writer.add_level(2, kLatest_ns, 13, "PC13", true);
  writer.add_volts(3, 0, 0, "A0", kThird);
  writer.add_pin(0, 8, 5, "D5", 2, false, false, 0, 0, 0);
  writer.add(events[7]);
  writer.add(events[8]);
  std::vector<std::string> lines;
  for (const Event& event : events) lines.push_back(line_of(event));
  return lines;
}

TEST(Batches, PreserveEventsExactlyAndInOrder) {
  BatchWriter writer;
  BatchReader reader(of_all());
  for (int again = 0; again < 2; ++again) {
    const std::vector<std::string> meant = add_all(writer);
    EXPECT_EQ(writer.latest_ns(), 9);
    const std::string bytes = bytes_in(line_of(writer.take()));
    EXPECT_EQ(writer.size(), 0u);
    EXPECT_EQ(told(reader, bytes), meant);
  }
}

TEST(Batches, ComputeYawFromSineAndCosine) {
  BatchWriter writer;
  const double sine = -0.6, cosine = 0.8;
  ASSERT_TRUE(writer.add_sample(1, 20'000, {1, 2, sine, cosine, 4, 5, 6, 7, 8, 9}, {0.5}));
  BatchReader reader(of_all());
  const Sample meant{20'000, 1, 2, std::atan2(sine, cosine), 4, 5, 6, 7, {0.5}, "", {8, 9}, 1};
  EXPECT_EQ(told(reader, writer.take().bytes), std::vector{line_of(meant)});
  const std::vector<double> endless(BatchMemory::kRoom_bytes / sizeof(double));
  EXPECT_FALSE(writer.add_sample(1, 20'000, {}, endless));
}

TEST(Batches, GoOnInAnotherMemory) {
  BatchMemory one, other;
  BatchWriter writer(&one);
  const std::vector<std::string> meant = add_all(writer);
  writer.go_on_in(other);
  EXPECT_EQ(add_all(writer), meant);
  for (BatchMemory* memory : {&one, &other}) {
    BatchReader reader(of_all());
    EXPECT_EQ(told(reader, BatchWriter(memory).take().bytes), meant) << "each memory can be read by itself";
  }
}

TEST(Batches, ReportPinsLevelsAndSamplesOnlyOnRequest) {
  BatchWriter writer;
  RunRequest request;
  request.batches = true;
  const auto kinds = [&] {
    add_all(writer);
    BatchReader reader(request);
    return told(reader, writer.take().bytes).size();
  };
  EXPECT_EQ(kinds(), 2u) << "a reader always reports serial bytes";
  request.pins = true;
  EXPECT_EQ(kinds(), 5u);
  request.io = true;
  EXPECT_EQ(kinds(), 7u);
  request.samples_every_ns = 10'000'000;
  EXPECT_EQ(kinds(), 9u);
}

TEST(Batches, RejectEventsOtherThanPlainSamplesAndBytes) {
  Sample at_station, endless;
  at_station.at_station = "8";
  endless.readings.resize(BatchMemory::kRoom_bytes / sizeof(double));
  BatchWriter writer;
  for (const Event& event : {Event(Started{}), Event(Note{}), Event(SerialText{}), Event(Batch{}),
                             Event(at_station), Event(endless), Event(Columns{}), Event(PinChange{}),
                             Event(SerialByte{0, 1, true, {"loop", "Blink.ino", 7}})})
    EXPECT_FALSE(writer.add(event)) << line_of(event);
  EXPECT_EQ(writer.size(), 0u);
}

TEST(Batches, MakeTheColumnsThatTheRunWouldMake) {
  RunRequest request;
  request.batches = true;
  request.columns_every_ns = 10'000'000;
  const SourceLine set{"setup", "Blink.ino", 3}, high{"loop", "Blink.ino", 7};
  RunColumns meant({"D13", "A0"}, true);
  BatchWriter writer;
  BatchReader reader(request);
  Started started;
  started.readings = {"S1"};
  reader.begin(started);
  meant.begin(started.readings);
  writer.add_sources(0);
  const auto both = [&](std::int64_t t_ns, const SourceLine* source, int number, bool level) {
    meant.add_pin(0, t_ns, level ? PinLevel::high : PinLevel::low, level, 0, source);
    writer.add_pin(0, t_ns, 13, "D13", 2, level, false, level, 0, number);
  };
  writer.add_source(0, set);
  both(5, &set, 1, false);
  writer.add_source(0, high);
  both(10, &high, 2, true);
  both(20, &set, 1, true);  // adds no new level
  meant.add_volts(1, 30, 2.5);
  writer.add_volts(0, 30, 14, "A0", 2.5);
  std::vector<Columns> made;
  const auto keep = [&](const Event& event) { made.push_back(std::get<Columns>(event)); };
  reader.read(writer.take().bytes, keep);
  EXPECT_THAT(made, SizeIs(0)) << "no columns are due yet";
  for (const std::int64_t t_us : {1'990'000, 1'995'000, 2'000'000}) {
    Sample sample;
    sample.t_us = t_us;
    sample.readings = {0.25};
    if (t_us % 10'000 == 0) meant.add(sample);
    writer.add(sample);
  }
  reader.read(writer.take().bytes, keep);
  ASSERT_THAT(made, SizeIs(1));
  EXPECT_EQ(line_of(made[0]), line_of(meant.take()));
  both(2'000'000'001, &high, 2, false);
  reader.read(writer.take().bytes, keep);
  reader.finish(keep);
  ASSERT_THAT(made, SizeIs(2));
  EXPECT_EQ(line_of(made[1]), line_of(meant.take()));
}

TEST(Batches, CanBeReadAfterTheirWriterIsDestroyed) {
  BatchMemory memory;
  const std::vector<std::string> meant = add_all(*std::make_unique<BatchWriter>(&memory));
  BatchReader reader(of_all());
  EXPECT_EQ(told(reader, BatchWriter(&memory).take().bytes), meant);
  memory.used = 4'000'000'000;  // simulates firmware that has overwritten this member
  EXPECT_THAT(BatchWriter(&memory).take().bytes, SizeIs(BatchMemory::kRoom_bytes));
}

TEST(Batches, ThatAreCutOffOrDamagedAreRefused) {
  const auto refusal = [](const std::string& bytes) -> std::string {
    try {
      BatchReader(of_all()).read(bytes, [](const Event&) {});
    } catch (const RunnerError& error) {
      return error.what();
    }
    return "";
  };
  BatchWriter writer;
  writer.add_source(0, {"loop", "Blink.ino", 7});
  add_all(writer);
  writer.add_pin(0, 9, 5, "D5", 2, true, false, 1, 0, 1);
  const std::string whole = writer.take().bytes;
  EXPECT_EQ(refusal(whole), "");
  std::size_t refused = 0;
  for (std::size_t size = 1; size < whole.size(); ++size) refused += !refusal(whole.substr(0, size)).empty();
  EXPECT_GE(refused, whole.size() - 20) << "a batch that ends between two events is accepted";
  EXPECT_THAT(refusal("?" + whole.substr(1)), HasSubstr("a batch with an incomplete event"));
  const std::string zero(8, '\0'), back = std::string("b\0\0\0\xFF\xFF\xFF\xFF", 8);
  EXPECT_THAT(refusal(back), HasSubstr("incomplete event")) << "a time before 0";
  EXPECT_THAT(refusal("t" + zero.substr(1) + std::string(8, '\xFF')), HasSubstr("incomplete event"));
  EXPECT_THAT(refusal("v" + zero.substr(1) + zero), HasSubstr("incomplete event")) << "a pin without a name";
  EXPECT_THAT(refusal("s" + zero.substr(1, 3) + "\xFF\xFF\xFF\xFF" + std::string(80, '\0')),
              HasSubstr("incomplete event"));
}

}  // namespace batch_test
}  // namespace robosim::wire
