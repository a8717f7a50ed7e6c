#include "sim/wire/columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/base64.h"
#include "sim/wire/json_writer.h"
#include "sim/wire/protocol.h"
#include "sim/wire/run_columns.h"
#include "sim/wire/stream.h"

namespace robosim::wire {
namespace columns_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Columns, HoldAnyNumberThatTheyCanAndTheNearestOtherwise) {
  const std::vector<double> values{0.0, 1e12, -1e12, 0.004, -0.006, 1e300, -1e300, std::nan("")};
  for (const int order : {1, 2}) {
    Column column({"c", 100.0, order});
    for (const double value : values) column.add(&value, 1, 1);
    const auto read = ColumnReader(order).read(column.bytes(), values.size());
    ASSERT_TRUE(read);
    EXPECT_THAT(*read,
                ElementsAre(0, 100'000'000'000'000, -100'000'000'000'000, 0, -1, kMostSteps, -kMostSteps, 0));
  }
}

TEST(Columns, GoOnWhereTheLastPieceEnded) {
  Stream stream("s", {{"t", 1, 2}});
  ColumnReader reader(2);
  for (double t = 0; t < 100; t += 10) {
    stream.add(&t);
    const Rows rows = stream.take();
    EXPECT_EQ(rows.columns.empty(), t > 0) << "the columns are sent once";
    const auto read = reader.read(rows.bytes[0], 1);
    ASSERT_TRUE(read);
    EXPECT_THAT(*read, ElementsAre(t));
  }
}

TEST(Columns, ThatAreLongerOrShorterThanPromisedAreNotRead) {
  EXPECT_TRUE(ColumnReader(1).read({"\x02\x02", 2}, 2));
  EXPECT_FALSE(ColumnReader(1).read({"\x02\x02", 2}, 1));
  EXPECT_FALSE(ColumnReader(1).read({"\x02\x02", 2}, 3));
  EXPECT_FALSE(ColumnReader(1).read({"\x02\x82", 2}, 2)) << "the number is cut off";
  EXPECT_FALSE(ColumnReader(1).read(std::string(20, '\x80'), 1)) << "no number is so long";
}

TEST(RunColumns, HoldWhatIsNewAndNothingElse) {
  RunColumns columns({"D2", "A0"});
  columns.begin({"S1"});
  EXPECT_THAT(columns.take().streams, IsEmpty());
  for (int i = 0; i < 10; ++i)
    columns.add_pin(0, i, i < 5 ? PinLevel::low : PinLevel::high, i < 5 ? 0 : 1, 0);
  columns.add_volts(1, 7, 2.5);
  columns.add(Sample{});
  const Columns taken = columns.take();
  ASSERT_THAT(taken.streams, SizeIs(3));
  EXPECT_EQ(taken.streams[0].stream, "samples");
  EXPECT_THAT(taken.streams[0].columns, SizeIs(11));
  EXPECT_EQ(taken.streams[1].stream, "pin D2");
  EXPECT_EQ(taken.streams[1].count, 2);
  EXPECT_EQ(taken.streams[2].stream, "volts A0");
}

TEST(RunColumns, NameTheLineThatDrivesAPinOnce) {
  const SourceLine set{"setup", "Blink.ino", 3}, high{"loop", "Blink.ino", 7};
  RunColumns columns({"D13"}, true);
  columns.add_pin(0, 10, PinLevel::low, 0.0, 0, &set);
  columns.add_pin(0, 20, PinLevel::high, 1.0, 0, &high);
  const Columns first = columns.take();
  ASSERT_THAT(first.sources, SizeIs(2));
  EXPECT_EQ(first.sources[1].line, 7);
  columns.add_pin(0, 30, PinLevel::low, 0.0, 0, &high);
  columns.add_pin(0, 40, PinLevel::high, 1.0, 0, nullptr);
  const Columns next = columns.take();
  EXPECT_THAT(next.sources, IsEmpty());
  ASSERT_EQ(first.streams[0].columns.back().name, "source");
  ColumnReader reader(1);
  EXPECT_THAT(*reader.read(first.streams[0].bytes.back(), 2), ElementsAre(1, 2));
  EXPECT_THAT(*reader.read(next.streams[0].bytes.back(), 2), ElementsAre(2, 0));
}

TEST(ALineOfColumns, IsJsonWithBase64AndIsReadBack) {
  const std::string longer(100, 'q'), odd = "\n\" \\ \x01 \xFF, and more of it than is left in the line";
  const Columns columns{{{"samples",
                          2,
                          {{"t_us", 1, 2}, {"a name \"in\" quotes, of more than 24 letters", 10, 1}},
                          {longer, std::string(1, '\0')}},
                         {"pin D2", 1, {}, {longer + "/+", odd}},
                         {"none", 0, {}, {}}},
                        0,
                        {{"loop", "Blink.ino", 7}, {"", "a \"name\", and a long one.h", 1}}};
  const std::string line = to_line(Id(std::int64_t{7}), Answer(Event(columns)));
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["streams"][0]["columns"],
            nlohmann::json::parse(text_of(to_json(columns.streams[0].columns))));
  EXPECT_EQ(json["streams"][1]["bytes"], nlohmann::json({base64(longer + "/+"), base64(odd)}));
  EXPECT_EQ(json["sources"], nlohmann::json::parse(text_of(to_json(columns.sources))));
  const Line read = parse_line(line);
  EXPECT_EQ(read.id, 7);
  const auto& streams = std::get<Columns>(std::get<Event>(read.content)).streams;
  ASSERT_THAT(streams, SizeIs(3));
  const auto& sources = std::get<Columns>(std::get<Event>(read.content)).sources;
  ASSERT_THAT(sources, SizeIs(2));
  EXPECT_EQ(sources[1].file, columns.sources[1].file);
  EXPECT_EQ(streams[0].columns[1].name, columns.streams[0].columns[1].name);
  EXPECT_THAT(streams[0].bytes, ElementsAre(longer, std::string(1, '\0')));
  EXPECT_THAT(streams[1].bytes, ElementsAre(longer + "/+", odd));

  const Columns plain{
      {{"samples", 2, {{"of a column, a name of many letters", 1, 2}}, {longer, longer + "2"}}}};
  const Line again = parse_line(to_line(Id(), Answer(Event(plain))));
  const auto& rows = std::get<Columns>(std::get<Event>(again.content)).streams[0];
  EXPECT_EQ(rows.columns[0].name, plain.streams[0].columns[0].name);
  EXPECT_THAT(rows.bytes, ElementsAre(longer, longer + "2"));
  EXPECT_THROW(
      parse_line(R"({"id":1,"event":"columns","streams":[{"stream":"s","count":1,"bytes":["no base64"]}]})"),
      RunnerError);
}

TEST(PinLevels, ArePulsingWhereEdgesAreTooFastToBeTold) {
  EXPECT_EQ(pin_level(PinChange{0, "D5", "output", false, true, 0.25, 0, {}}), PinLevel::pulsing);
  EXPECT_EQ(pin_level(PinChange{0, "D5", "output", false, true, 1.0, 0, {}}), PinLevel::high);
  EXPECT_EQ(pin_level(PinChange{0, "D5", "output", false, false, 0.0, 440, {}}), PinLevel::pulsing);
  EXPECT_EQ(pin_level(PinChange{0, "D5", "input_pullup", false, false, 0.0, 0, {}}), PinLevel::high);
  EXPECT_EQ(pin_level(PinChange{0, "D5", "input", false, false, 0.0, 0, {}}), PinLevel::floating);
}

}  // namespace columns_test
}  // namespace robosim::wire
