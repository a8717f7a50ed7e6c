#include "sim/view/terminal/terminal.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace robosim::terminal {
namespace terminal_test {

TEST(Keys, AreTakenOneByOne) {
  std::string bytes = " +-qf\033[A\033[B\033OC\033[Dx";
  for (const Key key : {Key::space, Key::plus, Key::minus, Key::quit, Key::follow, Key::up, Key::down,
                        Key::right, Key::left, Key::other, Key::none}) {
    EXPECT_EQ(take_key(bytes), key);
  }
}

TEST(Keys, AnUnfinishedSequenceWaitsForItsRest) {
  std::string bytes = "\033";
  EXPECT_EQ(take_key(bytes), Key::none);
  bytes += "[";
  EXPECT_EQ(take_key(bytes), Key::none);
  bytes += "1;5C";
  EXPECT_EQ(take_key(bytes), Key::right);
  EXPECT_TRUE(bytes.empty());
}

TEST(Keys, OtherSequencesAreSkippedWhole) {
  std::string bytes = "\033[3~q";
  EXPECT_EQ(take_key(bytes), Key::other);
  EXPECT_EQ(take_key(bytes), Key::quit);
}

/// A pseudo-terminal. The tests read the screen's output at `master_`.
class ScreenTest : public ::testing::Test {
 protected:
  ScreenTest() {
    const winsize size{30, 100, 0, 0};
    if (::openpty(&master_, &terminal_, nullptr, nullptr, &size) != 0) std::abort();
    ::tcgetattr(terminal_, &before_);
  }
  ~ScreenTest() override {
    ::close(master_);
    ::close(terminal_);
  }
  std::string written() const {
    char chunk[4096];
    const ssize_t n = ::read(master_, chunk, sizeof chunk);
    return {chunk, static_cast<std::size_t>(n > 0 ? n : 0)};
  }
  bool as_before() const {
    termios now{};
    ::tcgetattr(terminal_, &now);
    return now.c_lflag == before_.c_lflag && now.c_cc[VMIN] == before_.c_cc[VMIN];
  }
  int master_ = -1, terminal_ = -1;
  termios before_{};
};

TEST_F(ScreenTest, LeavesTheTerminalAsItWas) {
  {
    const Screen screen(terminal_, terminal_, {true, false});
    EXPECT_EQ(written(), "\033[?1049h\033[?25l\033[0m\033[2J\033[H");
    EXPECT_FALSE(as_before());
  }
  EXPECT_TRUE(as_before());
  EXPECT_EQ(written(), "\033[0m\033[?25h\033[?1049l");
}

TEST_F(ScreenTest, LeavesTheTerminalAsItWasAfterAnException) {
  try {
    const Screen screen(terminal_, terminal_, {true, false});
    throw 1;
  } catch (int) {
  }
  EXPECT_TRUE(as_before());
}

TEST_F(ScreenTest, LeavesTheTerminalAsItWasWhenTheProgramDies) {
  EXPECT_EXIT(
      {
        const Screen screen(terminal_, terminal_, {true, false});
        ::raise(SIGABRT);
      },
      ::testing::KilledBySignal(SIGABRT), "");
  EXPECT_TRUE(as_before());
}

TEST_F(ScreenTest, KnowsItsSizeKeysAndChanges) {
  Screen screen(terminal_, terminal_, {true, false});
  written();
  EXPECT_EQ(screen.size(), (TerminalSize{100, 30}));
  EXPECT_EQ(screen.wait_key(0), Key::none);
  ASSERT_EQ(::write(master_, "q", 1), 1);
  EXPECT_EQ(screen.wait_key(1000), Key::quit);
  Frame frame(100, 30);
  frame.put(0, 0, "a");
  screen.show(frame);
  EXPECT_EQ(written(), "\033[2J\033[1;1Ha");
  frame.put(1, 0, "b");
  screen.show(frame);
  EXPECT_EQ(written(), "\033[1;2Hb");
}

// Ctrl-C may discard typed characters between poll() and read().
TEST_F(ScreenTest, AReadThatBringsNothingIsNoHangUp) {
  {
    Screen screen(terminal_, terminal_, {true, false});
    termios lines = before_;
    lines.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ::tcsetattr(terminal_, TCSANOW, &lines);
    ASSERT_EQ(::write(master_, "\004", 1), 1);  // Ctrl-D, so that read() returns 0 bytes
    EXPECT_EQ(screen.wait_press(1000).kind, Press::Kind::nothing);
    EXPECT_TRUE(screen.has_keys());
  }
  EXPECT_TRUE(as_before());
}

TEST_F(ScreenTest, AHangUpIsTheEndOfTheKeys) {
  Screen screen(terminal_, terminal_, {true, false});
  ::close(std::exchange(master_, -1));
  EXPECT_EQ(screen.wait_press(1000).kind, Press::Kind::nothing);
  EXPECT_EQ(screen.wait_press(1000).kind, Press::Kind::end);
}

TEST_F(ScreenTest, NoticesAResize) {
  Screen screen(terminal_, terminal_, {true, false});
  EXPECT_FALSE(screen.take_resized());
  ::raise(SIGWINCH);
  EXPECT_TRUE(screen.take_resized());
  EXPECT_FALSE(screen.take_resized());
}

TEST(TerminalSize, IsUnknownForAPipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_FALSE(terminal_size(ends[0]));
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace terminal_test
}  // namespace robosim::terminal
