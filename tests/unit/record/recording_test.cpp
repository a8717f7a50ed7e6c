#include "sim/record/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/record/compressed.h"
#include "sim/record/record_page.h"
#include "sim/wire/run_columns.h"
#include "tests/support/temporary_folder.h"

namespace robosim::record {
namespace recording_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// Returns the error message for an unreadable recording.
std::string refusal(const std::string& bytes) {
  try {
    Recording::decode(bytes, "x.rec");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

class ARecording : public ::testing::Test {
 protected:
  ARecording() {
    write_file(folder / "t.map", "+++\nname = \"t\"\ncorner = \"50 mm\"\n+++\n____#\n_S.._\n___._\n_____\n");
    run.sketch = "Mine";
    run.robot_info.board.name = "uno";
    run.robot_info.file = "/somewhere/else/uno5.toml";
    run.request.map = folder / "t.map";
    gatherer.begin(run);
    wire::Started started;
    started.x = started.y = 1;
    started.readings = {"S1", "distance"};
    gatherer.add(started);
    columns.begin(started.readings);
  }

  std::string encoded() {
    gatherer.add(columns.take());
    return gatherer.encoded({});
  }
  Recording written() { return Recording::decode(encoded(), "x.rec"); }

  const test::TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path();
  RecordedRun run;
  Gatherer gatherer;
  wire::RunColumns columns{{"D2", "D5", "A0"}};
};

constexpr std::size_t kD2 = 0, kD5 = 1, kA0 = 2;  // indices in `columns`

class TwoRobots : public ARecording {
 protected:
  TwoRobots() : both(nullptr, 300) {  // 300 is the limit in bytes for the changes of both robots
    run.robots = {{"A", "Mine", "uno5", "host", run.robot_info},
                  {"B", "Yours", "mega5", "avr", run.robot_info}};
    run.request.agents.emplace_back().script = "at 1s power off\n";
    both.begin(run);
    for (const int agent : {0, 1}) {
      wire::Started started;
      started.agent = agent;
      started.readings = {agent == 0 ? "S1" : "T1"};
      both.add(started);
      of[agent].begin(started.readings);
      wire::Sample sample;
      sample.x_mm = 100.0 + agent;
      sample.readings = {0.5};
      of[agent].add(sample);
    }
  }
  Recording written() {
    for (const int agent : {0, 1}) {
      wire::Columns own = of[agent].take();
      own.agent = agent;
      both.add(own);
      both.add(wire::SerialText{agent, agent == 0 ? "a\n" : "bb\n", agent});
      both.add(wire::Note{5 + agent, "it happened", std::nullopt, agent});
    }
    result::RunResult result;
    result.verdict = "reached";
    result.others.emplace_back().verdict = "lost";
    return Recording::decode(both.encoded(result), "x.rec");
  }

  Gatherer both;
  wire::RunColumns of[2]{wire::RunColumns{{"D2"}}, wire::RunColumns{{"D2"}}};
};

TEST_F(TwoRobots, HaveSeparateRecordsInOneRecording) {
  const Recording recording = written();
  const RecordingHeader& header = recording.header();
  ASSERT_EQ(header.robot_count(), 2u);
  EXPECT_EQ(header.name + header.sketch + header.result.verdict, "AMinereached");
  EXPECT_EQ(header.of(1).name + header.of(1).sketch + header.of(1).result.verdict, "BYourslost");
  EXPECT_EQ(header.of(1).script, "at 1s power off\n");
  EXPECT_THAT(header.of(1).started.readings, ElementsAre("T1"));
  EXPECT_THAT(header.result.others, SizeIs(0));
  EXPECT_THAT(recording.stream("samples", 0)[1], ElementsAre(100.0));
  EXPECT_THAT(recording.stream("samples", 1)[1], ElementsAre(101.0));
  std::vector<std::string> told;
  recording.play([&](const wire::Event& event) {
    if (const auto* text = std::get_if<wire::SerialText>(&event))
      told.push_back(std::to_string(text->agent) + text->text);
    if (const auto* note = std::get_if<wire::Note>(&event))
      told.push_back(std::to_string(note->agent) + note->text);
    if (const auto* sample = std::get_if<wire::Sample>(&event))
      told.push_back(std::to_string(sample->agent) + "at" + std::to_string(std::lround(sample->x_mm)));
  });
  EXPECT_THAT(told, ElementsAre("0at100", "0a\n", "1at101", "1bb\n", "0it happened", "1it happened"));
}

TEST_F(TwoRobots, AreThinnedSeparatelyBeyondHalfTheLimit) {
  for (int i = 0; i < 100; ++i)
    of[1].add_pin(kD2, 1'000'000 * i, i % 2 == 0 ? wire::PinLevel::high : wire::PinLevel::low, i % 2, 0);
  const Recording recording = written();
  EXPECT_EQ(recording.header().thinned_ns, 0);
  EXPECT_EQ(recording.header().of(1).thinned_ns, Gatherer::kThinned_ns);
  EXPECT_THAT(recording.stream("pin D2", 1)[0], SizeIs(5));
}

TEST_F(ARecording, PreservesSamplesToTheResolutionOfDrawings) {
  const wire::Sample sample{10000,     1352.123, 248.956,       -3.14, -310.04,        1.256,
                            -0.503921, 1.0,      {0.25, -41.5}, "",    {-300.0, 12.34}};
  columns.add(wire::Sample{0, 0.0, 0.0, 3.1, 0.0, 0.0, 0.0, 0.0, {0.0, 0.0}});
  columns.add(sample);
  std::vector<wire::Sample> played;
  written().play([&](const wire::Event& event) {
    if (const auto* one = std::get_if<wire::Sample>(&event)) played.push_back(*one);
  });
  ASSERT_THAT(played, SizeIs(2));
  const wire::Sample& s = played[1];
  EXPECT_EQ(s.t_us, 10000);
  EXPECT_NEAR(s.x_mm, sample.x_mm, 0.00501);
  EXPECT_NEAR(s.y_mm, sample.y_mm, 0.00501);
  EXPECT_NEAR(s.yaw_rad, sample.yaw_rad, 0.0000501);
  EXPECT_NEAR(s.speed_mm_s, sample.speed_mm_s, 0.0501);
  EXPECT_NEAR(s.left, sample.left, 0.000501);
  EXPECT_THAT(s.readings, ElementsAre(0.25, -41.5));
  EXPECT_NEAR(s.wheels_mm_s[1], 12.34, 0.0501);
}

TEST_F(ARecording, KeepsTimesOfPinsToTheNanosecond) {
  columns.add_pin(kD5, 3'599'999'999'937, wire::PinLevel::pulsing, 0.25, 0);
  gatherer.add(columns.take());  // later times are stored relative to this change
  columns.add_pin(kD5, 3'600'000'000'000, wire::PinLevel::high, 1.0, 0);
  const auto pin = written().stream("pin D5");
  ASSERT_THAT(pin, SizeIs(4));
  EXPECT_THAT(pin[0], ElementsAre(3'599'999'999'937, 3'600'000'000'000));
  EXPECT_THAT(pin[1], ElementsAre(3, 1)) << "pulsing, then high";
  EXPECT_THAT(pin[2], ElementsAre(0.25, 1.0));
}

TEST_F(ARecording, StoresTheSourceLineOfEachPinChange) {
  const result::SourceLine on{"setup", "Blink.ino", 3}, off{"loop", "Blink.ino", 7};
  wire::RunColumns known{{"D2"}, true};
  known.add_pin(0, 10, wire::PinLevel::high, 1.0, 0, &on);
  gatherer.add(known.take());
  known.add_pin(0, 20, wire::PinLevel::low, 0.0, 0, &off);
  gatherer.add(known.take());
  const Recording recording = written();
  const auto pin = recording.stream("pin D2");
  ASSERT_THAT(pin, SizeIs(5));
  EXPECT_THAT(pin[4], ElementsAre(1, 2));
  ASSERT_THAT(recording.header().sources, SizeIs(2));
  EXPECT_EQ(recording.header().sources[1].file, "Blink.ino");
  EXPECT_EQ(recording.header().sources[1].line, 7);
}

TEST_F(ARecording, SkipsPinEventsWithoutAChange) {
  for (int i = 0; i < 100; ++i)
    columns.add_pin(kD2, i * 1000, i >= 50 ? wire::PinLevel::high : wire::PinLevel::low, i >= 50, 0);
  EXPECT_THAT(written().stream("pin D2")[0], ElementsAre(0, 50'000));
}

TEST_F(ARecording, TellsSerialTextAndEventsInTheOrderOfTime) {
  gatherer.add(wire::SerialText{2'000'000'000, "grüße\r\n"});
  gatherer.add(wire::note_of({1'000'000'000, 0, result::CollisionBegan{}}));
  gatherer.add(wire::SerialText{3'000'000'000, "zwei\n"});
  std::vector<std::string> told;
  written().play([&](const wire::Event& event) {
    if (const auto* serial = std::get_if<wire::SerialText>(&event)) told.push_back(serial->text);
    if (const auto* note = std::get_if<wire::Note>(&event))
      told.push_back(note->is<result::CollisionBegan>() ? "a collision" : "?");
  });
  EXPECT_THAT(told, ElementsAre("a collision", "grüße\r\n", "zwei\n"));
}

TEST_F(ARecording, StoresTheShapesOfTheFloor) {
  const Recording recording = written();
  const auto& floor = recording.header().floor;
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->width_mm, 500.0);
  EXPECT_THAT(floor->walls, ElementsAre(std::array<double, 4>{400, 300, 100, 100}));
  ASSERT_THAT(floor->stripes, SizeIs(3)) << "two legs and the arc between them";
  EXPECT_THAT(floor->stripes[1].arc, ElementsAre(300.0, 200.0, 50.0));
}

TEST_F(ARecording, NamesNoFolderOfThisMachine) { EXPECT_EQ(written().header().robot_info.file, "uno5.toml"); }

TEST_F(ARecording, KeepsOnlyTheLastChangePerSpanBeyondTheLimit) {
  constexpr int kChanges = 10'000;
  Gatherer small(std::make_unique<Deflater>(), 20'000);
  small.begin(run);
  for (int i = 0; i < kChanges; ++i) {
    columns.add_volts(kA0, i * std::int64_t{100'000}, 0.001 * (i * 7919 % 5000));
    if (i % 1000 == 999) small.add(columns.take());
  }
  const Recording recording = Recording::decode(small.encoded({}), "x.rec");
  EXPECT_EQ(recording.header().thinned_ns, Gatherer::kThinned_ns);
  const auto volts = recording.stream("volts A0");
  EXPECT_THAT(volts[0], SizeIs(kChanges / 200));
  EXPECT_EQ(volts[0][0], 199 * 100'000) << "the last change in the first 20 ms";
  EXPECT_DOUBLE_EQ(volts[1][0], 0.001 * (199 * 7919 % 5000));
}

/// Packs and unpacks as Deflater does. Counts the uncompressed bytes of both operations.
class CountingPacker final : public Packer {
 public:
  explicit CountingPacker(std::size_t& bytes, std::size_t* unpacked_bytes = nullptr)
      : bytes_(bytes), unpacked_bytes_(unpacked_bytes) {}
  void pack(std::string_view piece, Packed& to) override {
    bytes_ += piece.size();
    deflater_.pack(piece, to);
  }
  std::string unpacked(std::string_view packed, std::size_t unpacked_size) override {
    if (unpacked_bytes_) *unpacked_bytes_ += unpacked_size;
    return deflater_.unpacked(packed, unpacked_size);
  }

 private:
  std::size_t& bytes_;
  std::size_t* unpacked_bytes_;
  Deflater deflater_;
};

TEST_F(ARecording, HasTheSameContentIfItIsThinnedGradually) {
  constexpr std::size_t kMost_bytes = 400'000;
  std::size_t packed_bytes = 0, unpacked_bytes = 0, most_at_a_time = 0;
  Gatherer slowly(std::make_unique<CountingPacker>(packed_bytes, &unpacked_bytes), kMost_bytes);
  Gatherer at_once(nullptr, kMost_bytes);  // without a packer, thins nothing until the limit is reached
  for (Gatherer* both : {&slowly, &at_once}) both->begin(run);
  for (std::int64_t i = 0; i < 200'000; ++i) {
    columns.add_volts(kA0, i * 1'000'000, 0.001 * static_cast<double>(i * 7919 % 5000));
    if (i % 3 == 0) columns.add_pin(kD5, i * 1'000'037, wire::PinLevel::pulsing, 0.0001 * (i % 9999), 0);
    if (i == 150'000) columns.add_pin(kD2, i * 1'000'000, wire::PinLevel::high, 1.0, 0);
    if (i % 500 != 499) continue;
    const wire::Columns piece = columns.take();
    const std::size_t before = unpacked_bytes;
    for (Gatherer* both : {&slowly, &at_once}) both->add(piece);
    most_at_a_time = std::max(most_at_a_time, unpacked_bytes - before);
  }
  EXPECT_GT(unpacked_bytes, kMost_bytes * 3 / 4) << "thinning unpacks most of what was packed before";
  EXPECT_LT(most_at_a_time, kMost_bytes / 10) << "each step unpacks only a small part";
  EXPECT_EQ(slowly.content({}), at_once.content({}));
  EXPECT_EQ(slowly.header().thinned_ns, Gatherer::kThinned_ns);
}

TEST_F(ARecording, HasTheSameContentIfItIsCompressedDuringTheRun) {
  std::size_t packed_bytes = 0;
  Gatherer packing(std::make_unique<CountingPacker>(packed_bytes));
  packing.begin(run);
  packing.add(gatherer.header().started);
  for (int i = 0; i < 20'000; ++i) {
    wire::Sample sample;
    sample.t_us = i * std::int64_t{10'000};
    sample.x_mm = i * 7919 % 5000;
    columns.add(sample);
    if (i % 1000 != 999) continue;
    const wire::Columns piece = columns.take();
    const wire::SerialText text{sample.t_us * 1000, "now at " + std::to_string(i) + "\n"};
    for (Gatherer* both : {&packing, &gatherer}) {
      both->add(piece);
      both->add(text);
    }
  }
  const std::string compressed = packing.encoded({}).substr(std::string(kRecordingMagic).size());
  const std::string content = gatherer.content({});
  EXPECT_EQ(inflated(compressed, content.size()), content);
  EXPECT_GT(packed_bytes, content.size() * 3 / 4) << "the rest waits for the end";
}

TEST_F(ARecording, IsTheSameInAPage) {
  const auto page = folder / "run.html", rec = folder / "run.rec";
  PageRecorder in_page(page);
  RecRecorder alone(rec);
  for (Recorder* recorder : {static_cast<Recorder*>(&in_page), static_cast<Recorder*>(&alone)}) {
    recorder->begin(run);
    recorder->add(wire::Started{});
    recorder->finish({});
  }
  EXPECT_EQ(recording_in(read_file(page)), read_file(rec));
  EXPECT_EQ(Recording::read(page).header().sketch, "Mine");
  EXPECT_EQ(Recording::read(rec).header().sketch, "Mine");
}

TEST_F(ARecording, ThatIsDamagedIsRefusedWithASentence) {
  columns.add(wire::Sample{});
  const std::string good = encoded();
  EXPECT_EQ(refusal(good), "");
  EXPECT_THAT(refusal(good.substr(0, good.size() - 1)), HasSubstr("x.rec: not a readable recording"));
  EXPECT_THAT(refusal(good.substr(0, 20)), HasSubstr("damaged or cut off"));
  EXPECT_THAT(refusal("robosim.rec/2\n"), HasSubstr("made by a newer version of Robosim"));
  EXPECT_THAT(refusal("t_us,x_mm"), HasSubstr("does not begin like a recording"));
  EXPECT_THAT(refusal(kRecordingMagic + deflated("[]\n")), HasSubstr("expected an object"));
  EXPECT_THAT(refusal(kRecordingMagic + deflated("no JSON")), HasSubstr("its header is damaged"));
}

TEST_F(ARecording, ThatIsTooLargeOrNestedTooDeeplyIsRefused) {
  const auto refusal_of = [&](const std::string& content) {
    return refusal(kRecordingMagic + deflated(content));
  };
  const std::string magic = "x.rec: not a readable recording: ";
  EXPECT_EQ(refusal_of(std::string(17 << 20, ' ')), magic + "its content is too large")
      << "a header without an end";
  EXPECT_EQ(refusal_of("{\"a\":" + std::string(1000, '[') + std::string(1000, ']') + "}\n"),
            magic + "its header is damaged");
  std::string wide = "{\"a\":[";
  for (int i = 0; i < 2'100'000; ++i) wide += "0,";
  EXPECT_EQ(refusal_of(wide + "0]}\n"), magic + "its header is damaged");
  const std::string all = inflated(encoded().substr(std::string(kRecordingMagic).size()), 1 << 20);
  EXPECT_EQ(refusal_of(all + std::string(65 << 20, '\0')), magic + "its content is too large");
}

TEST_F(ARecording, ThatPromisesMoreThanItHoldsIsRefused) {
  columns.add(wire::Sample{});
  std::string all = inflated(encoded().substr(std::string(kRecordingMagic).size()), 1 << 20);
  const std::size_t at = all.find("\"count\":1");
  ASSERT_NE(at, std::string::npos);
  all.replace(at, 9, "\"count\":9");
  const Recording more = Recording::decode(kRecordingMagic + deflated(all), "x.rec");
  EXPECT_THROW(more.stream("samples"), InputError);
  all.erase(all.size() - 1);
  EXPECT_THAT(refusal(kRecordingMagic + deflated(all)), HasSubstr("longer than the file"));
}

TEST_F(ARecording, WithTwoStreamsOfOneNameIsRefused) {
  columns.add(wire::Sample{});
  std::string all = inflated(encoded().substr(std::string(kRecordingMagic).size()), 1 << 20);
  const std::size_t streams = all.find("\"streams\":[");
  ASSERT_NE(streams, std::string::npos);
  all.insert(streams + 11, R"({"name":"samples","count":1,"columns":[]},)");
  EXPECT_THAT(refusal(kRecordingMagic + deflated(all)), HasSubstr("two streams of the name"));
}

}  // namespace recording_test
}  // namespace robosim::record
