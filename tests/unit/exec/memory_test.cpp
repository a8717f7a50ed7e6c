// Tests the heap of a sketch on the host, and writes beyond the heap.
#include "tests/unit/exec/fixture.h"

namespace robosim::exec::memory_test {

using testing::ElementsAre;
using testing::HasSubstr;

using MemoryTest = HostTest;

TEST_F(MemoryTest, TheHeapIsFreshAlignedAndGivesBackWhatIsFreed) {
  output(R"(void setup() {
  Serial.begin(115200);
  long round = 0;
  for (; round < 10000; ++round) {
    char* a = (char*)malloc(1000 + round % 7);
    char* b = (char*)malloc(50);
    if (!a || !b || (size_t)a % 16 || (size_t)b % 16) break;
    memset(a, 1, 1000);
    memset(b, 2, 50);
    free(round % 2 ? a : b);
    free(round % 2 ? b : a);
  }
  Serial.println(round);
  int* p = (int*)calloc(10, sizeof(int));
  p = (int*)realloc(p, 400 * sizeof(int));
  Serial.println(p[9]);
  delete new String("x");
}
void loop() {})",
         5 * kSecond);
  EXPECT_THAT(numbers(), ElementsAre(10000, 0));
}

TEST_F(MemoryTest, AnExhaustedHeapGivesNull) {
  output(R"(void setup() {
  Serial.begin(115200);
  int blocks = 0;
  while (malloc(1000)) ++blocks;
  Serial.println(blocks > 30 && blocks < 70);
  Serial.println(malloc(100000000) == nullptr);
  String s; for (int i = 0; i < 100; ++i) s += "longer and longer";
  Serial.println(s.length() < 1700);
}
void loop() {})",
         5 * kSecond);
  EXPECT_THAT(numbers(), ElementsAre(1, 1, 1));
}

TEST_F(MemoryTest, AnOverrunStopsAtTheHeapsEnd) {
  start(
      "void setup() {\n  volatile char* p = (char*)malloc(10);\n  for (long i = 0;; ++i)\n    p[i] = "
      "1;\n}\nvoid loop() {}\n");
  run(kSecond);
  ASSERT_TRUE(host_->crash());
  // Only an x86 processor tells the signal handler whether the access was a write.
  EXPECT_THAT(host_->crash()->reason, testing::AnyOf("write outside the heap", "access outside the heap"));
  EXPECT_EQ(host_->crash()->where.line, 4);
}

TEST_F(MemoryTest, ADamagedHeapIsNoticedWhenItIsUsedNext) {
  start(R"(void* volatile keep;
void setup() {
  volatile char* p = (char*)malloc(10);
  for (int i = 0; i < 100; ++i) p[i] = 77;
  keep = malloc(5);
}
void loop() {})");
  run(kSecond);
  ASSERT_TRUE(host_->crash());
  EXPECT_THAT(host_->crash()->reason, HasSubstr("the heap is damaged"));
  EXPECT_EQ(host_->crash()->where.file, "Test.ino");
}

TEST_F(MemoryTest, FreeOfWhatMallocDidNotGiveIsACrash) {
  const auto reason = [&](const std::string& frees) {
    start("char own[64]; char* volatile p;\nvoid setup() { p = (char*)malloc(9); " + frees +
          " }\nvoid loop() {}");
    run(100 * kMillisecond);
    return host_->crash() ? host_->crash()->reason : "";
  };
  EXPECT_EQ(reason("p = own + 32; free(p);"), "free() or realloc() of memory that malloc() did not return");
  EXPECT_EQ(reason("free(p);"), "");
}

TEST_F(MemoryTest, OneFirmwaresOverrunDoesNotHarmAnother) {
  const std::filesystem::path good = build(
      "int n; void setup() { Serial.begin(115200); } void loop() { char* p = (char*)malloc(16); strcpy(p, "
      "\"ok\"); Serial.println(p); free(p); delay(10); }");
  HostExecutor other(*find_board("uno"), good);
  other.board().watch_serial(*this);
  other.power_on(0);
  start(
      "void setup() { volatile char* p = (char*)malloc(10); for (long i = 0;; ++i) p[i] = 1; } void loop() "
      "{}");
  for (int tick = 1; tick <= 100; ++tick) {
    host_->run_until(tick * kTick);
    other.run_until(tick * kTick);
  }
  EXPECT_TRUE(host_->crash());
  EXPECT_FALSE(other.crash());
  EXPECT_EQ(serial_.size(), 40u);
}

}  // namespace robosim::exec::memory_test
