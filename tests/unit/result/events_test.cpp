#include "sim/result/events.h"

#include <gtest/gtest.h>

namespace robosim::result {
namespace events_test {

TEST(RunEvents, HaveOneTextEach) {
  const auto text = [](RunEvent::What what) { return text_of({0, 0, std::move(what)}); };
  EXPECT_EQ(text(StationVisited{"dock"}), "station dock visited");
  EXPECT_EQ(text(LapDone{2, 8.5449}), "lap 2 in 8.54 s");
  EXPECT_EQ(text(CollisionBegan{}), "collision with a wall, an obstacle or the map's edge");
  EXPECT_EQ(text(CollisionBegan{true}), "collision with another robot");
  EXPECT_EQ(text(ScriptActed{"send", "", "3\n"}), "\"3\\n\" sent to the sketch");
  EXPECT_EQ(text(ScriptActed{"send", "ir", "0b101"}), "0b101 sent to ir");
  EXPECT_EQ(text(ScriptActed{"cover", "S2", ""}), "S2 covered");
  EXPECT_EQ(text(ScriptActed{"uncover", "S2", ""}), "S2 uncovered");
  EXPECT_EQ(text(ScriptActed{"clear", "", "3,2"}), "obstacle on 3,2 taken away");
  EXPECT_EQ(text(FaultBegan{"power", {"brown-out"}, true}), "fault: power brown-out, which resets the chip");
  EXPECT_EQ(text(FaultEnded{"S2", {"stuck", "1023"}}), "fault over: S2 stuck 1023");
  EXPECT_EQ(text(FaultEnded{"S2", {"ok"}, true}), "fault: S2 ok");
  EXPECT_EQ(text(PowerLost{{{12, 0x5A}}}),
            "power cut while byte 12 of the EEPROM was being written; it now contains 0x5A");
  EXPECT_EQ(text(PowerLost{}), "power off");
  EXPECT_EQ(text(PartTold{"lcd", "Lap 2|12.4 s"}), "lcd: \"Lap 2|12.4 s\"");
  EXPECT_EQ(text(PowerBack{}), "power on");
  EXPECT_EQ(text(Scored{"gap", 10.0, "points"}), "gap: 10 points");
  EXPECT_EQ(text(Scored{"try 1, 24.31 s", 14.3149, "s"}), "try 1, 24.31 s: 14.31 s");
}

TEST(RunEvents, AreOfAKindWhateverTheirTextSays) {
  EXPECT_STREQ(kind_of({0, 0, StationVisited{"collision"}}), "station_visited");
  EXPECT_STREQ(kind_of({0, 0, Scored{}}), event_kinds().back().c_str());
}

}  // namespace events_test
}  // namespace robosim::result
