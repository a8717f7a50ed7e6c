// Tests the detection of a growing heap, and of failed allocations (sim/detect/avr/heap.h).

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::heap_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class HeapTest : public AvrDetectorTest {
 protected:
  std::vector<Detected> seen(const std::string& pass) {
    return found_in("String text; int n;\nvoid setup() { Serial.begin(115200); }\nvoid loop() {\n" + pass +
                        "\nSerial.println(text.length()); delay(50); }\n",
                    6 * kSecond);
  }
};

TEST_F(HeapTest, GrowsWhereATextIsKept) {
  const auto found = seen("text += 'x';");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "heap_grows");
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_THAT(found[0].what,
              HasSubstr("20 each second, and keeps growing: it will reach the stack in about"));
}

TEST_F(HeapTest, HasNoMemoryForAStringThatBecomesEmpty) {
  const auto found = seen("if (++n % 4 == 0) text.reserve(1800); else text = \"abc\";");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "no_memory");
  EXPECT_THAT(found[0].what, HasSubstr("no memory was left for 1801 bytes"));
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_EQ(found[0].times, 30);
}

TEST_F(HeapTest, LiesInPiecesWhereSomeTextsAreKept) {
  start(R"(
String kept[6]; byte n;
void setup() { Serial.begin(115200); }
void loop() {
  String text = "123456789";
  for (byte i = 0; i < n % 13; ++i) text += "abcdefg";
  if (n % 3 == 0) kept[n / 3 % 6] = text;
  ++n; Serial.println(text.length()); delay(50);
}
)");
  run(20 * kSecond);
  const auto found = avr_->detected();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "heap_in_pieces");
  EXPECT_THAT(found[0].what, HasSubstr("were free, in"));
  EXPECT_GE(found[0].times, 3);
}

TEST_F(HeapTest, SaysThatThereWasNoMemoryForItLayInPieces) {
  start(R"(
char* block[12]; char* large;
void setup() {
  Serial.begin(115200);
  for (byte i = 0; i < 12; ++i) block[i] = (char*)malloc(120);
  for (byte i = 0; i < 12; i += 2) free(block[i]);
}
void loop() { large = (char*)malloc(300); Serial.println(large == nullptr); delay(100); }
)");
  run(1 * kSecond);
  const auto found = avr_->detected();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "no_memory");
  EXPECT_THAT(found[0].what, HasSubstr("though 720 are free, in 6 pieces of which the largest has 120"));
}

TEST_F(HeapTest, IsWellWhereTextsComeAndGo) {
  EXPECT_THAT(seen("text = String(millis()) + \" ms\"; if (++n % 7 == 0) text += \" and a little more\";"),
              IsEmpty());
}

}  // namespace robosim::detect::heap_test
