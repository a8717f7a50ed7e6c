#include "sim/wire/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

using ::testing::HasSubstr;

std::vector<Event> all_kinds() {
  const double odd = 0.1 + 0.2, least = std::numeric_limits<double>::denorm_min();
  return {Sample{kLatest_ns / 1000, odd, -0.0, -1e308, least, 5, 6, 7, {odd, 0, 1023}, "", {8, 9}, 255},
          Sample{},
          PinChange{7, "D5", "output", true, true, odd, 4'000'000'000, {}, 0},
          PinChange{8, "", "input_pullup", false, false, 0, 0, {}, 1},
          LevelSeen{kLatest_ns, "PC13", true, {}, 2},
          VoltsSeen{0, "A0", odd, {}, 3},
          SerialByte{9, 0, true, {}, 4},
          SerialByte{9, 255, false, {}, 255},
          Columns{{{"samples", 2, {{"t_us", 1, 2}, {"S1", 1000}}, {std::string("\0\n\xFF", 3), ""}},
                   {"pin D2", 1, {}, {std::string(70'000, '\n')}},
                   {"none", 0, {}, {}}},
                  7,
                  {{"loop", "Blink.ino", 7}, {"", "", 0}}}};
}

std::string line_of(const Event& event) { return to_line(Id(std::int64_t{1}), Answer(event)); }

/// What a client has of it: the line says how many bytes there are behind it.
std::string bytes_in(const std::string& said) {
  const std::size_t end = said.find('\n') + 1;
  const Line line = parse_line(said.substr(0, end));
  EXPECT_EQ(std::get<Batch>(std::get<Event>(line.content)).size,
            std::ssize(said) - std::ssize(said.substr(0, end)));
  return said.substr(end);
}

TEST(Batches, GiveBackEachEventToTheLastBitInTheirOrder) {
  BatchWriter writer;
  const std::vector<Event> events = all_kinds();
  for (const Event& event : events) ASSERT_TRUE(writer.add(event)) << line_of(event);
  EXPECT_EQ(writer.since_ns(), kLatest_ns);
  EXPECT_EQ(writer.latest_ns(), 9);
  const std::string bytes = bytes_in(line_of(writer.take()));
  EXPECT_EQ(writer.size(), 0u);
  std::vector<std::string> told, meant;
  unpack(bytes, [&](const Event& event) { told.push_back(line_of(event)); });
  for (const Event& event : events) meant.push_back(line_of(event));
  EXPECT_EQ(told, meant);
}

TEST(Batches, HaveNoPlaceForWhatIsRareOrHasMoreToSay) {
  const SourceLine source{"loop", "Blink.ino", 7};
  Sample at_station;
  at_station.at_station = "8";
  BatchWriter writer;
  for (const Event& event :
       {Event(Started{}), Event(Note{}), Event(SerialText{}), Event(Batch{}), Event(at_station),
        Event(Columns{{{std::string(256, 'n'), 0, {}, {}}}}), Event(Columns{{{"s", 0, {{"t_us"}}, {}}}}),
        Event(Columns{{}, 256}), Event(PinChange{0, "D5", "output", true, false, 1, 0, source}),
        Event(PinChange{0, "D5", "odd"}), Event(LevelSeen{0, "D5", true, source}),
        Event(LevelSeen{0, std::string(256, 'D'), true, {}}), Event(VoltsSeen{0, "A0", 1, source}),
        Event(SerialByte{0, 1, true, source})})
    EXPECT_FALSE(writer.add(event)) << line_of(event);
  EXPECT_EQ(writer.size(), 0u);
}

TEST(Batches, ThatAreCutOffOrDamagedAreRefused) {
  const auto refusal = [](const std::string& bytes) -> std::string {
    try {
      unpack(bytes, [](const Event&) {});
    } catch (const RunnerError& error) {
      return error.what();
    }
    return "";
  };
  for (const Event& event : all_kinds()) {
    BatchWriter writer;
    writer.add(event);
    const std::string whole = writer.take().bytes;
    EXPECT_EQ(refusal(whole), "");
    for (std::size_t size = 1; size < whole.size(); size += 1 + size / 300)
      EXPECT_THAT(refusal(whole.substr(0, size)), HasSubstr("does not hold whole events")) << size;
    EXPECT_THAT(refusal("?" + whole.substr(1)), HasSubstr("whole events"));
    EXPECT_THAT(refusal(whole.substr(0, 2) + std::string(8, '\xFF') + whole.substr(10)),
                HasSubstr("whole events"))
        << "a time before 0";
  }
}

}  // namespace
}  // namespace robosim::wire
