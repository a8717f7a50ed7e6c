#include "sim/base/child.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <system_error>

#include "sim/base/process_state.h"

namespace robosim::child_test {

ChildStart shell(const std::string& script) {
  ChildStart start;
  start.words = {"/bin/sh", "-c", script};
  return start;
}

TEST(Child, ItsEndingIsToldInWords) {
  EXPECT_EQ(Child(shell("exit 3")).wait().text(), "ended with status 3");
  EXPECT_EQ(Child(shell("kill -9 $$")).wait().text(), "was ended by signal 9 (Killed)");
  EXPECT_TRUE(Child(shell("exit 0")).wait().ok());
}

TEST(Child, ItsStateIsThatOfTheKernelAndNothingOnceItIsGone) {
  EXPECT_EQ(process_state(::getpid()), 'R');
  Child child(shell("kill -STOP $$"));
  siginfo_t info{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child.pid()), &info, WSTOPPED | WNOWAIT), 0);
  EXPECT_EQ(process_state(child.pid()), 'T');
  const pid_t number = child.pid();
  child.send(SIGKILL);
  child.wait();
  EXPECT_EQ(process_state(number), '\0');
}

TEST(Child, AnEndingStaysKnown) {
  Child child(shell("exit 3"));
  child.wait();
  EXPECT_EQ(child.wait().status, 3);
  EXPECT_TRUE(child.has_ended());
}

TEST(Child, ItsOutputFolderAndEnvironmentAreThoseOfItsStart) {
  Pipe pipe;
  ChildStart start = shell("pwd; echo $NAME");
  start.folder = "/usr";
  start.environment = {"NAME=value"};
  start.output = pipe.write.get();
  Child child(start);
  pipe.write.close();
  child.wait();
  char text[100];
  const ssize_t n = ::read(pipe.read.get(), text, sizeof text);
  EXPECT_EQ(std::string(text, static_cast<std::size_t>(n)), "/usr\nvalue\n");
}

TEST(Child, ItDoesNotOutliveItsOwner) {
  Pipe pipe;
  {
    ChildStart start = shell("sleep 1000");
    start.output = pipe.write.get();
    start.own_group = true;
    const Child child(start);
    pipe.write.close();
  }
  char byte;
  EXPECT_EQ(::read(pipe.read.get(), &byte, 1), 0) << "no process is left that could write";
}

TEST(Child, ASignalThatWeIgnoreMayBeItsAgain) {
  const auto before = ::signal(SIGINT, SIG_IGN);
  EXPECT_EQ(Child(shell("kill -INT $$; exit 7")).wait().status, 7);
  ChildStart start = shell("kill -INT $$; exit 7");
  start.default_signals = {SIGINT};
  EXPECT_EQ(Child(start).wait().signal, SIGINT);
  ::signal(SIGINT, before);
}

TEST(Child, ACopyOfThisProcessEndsWithItsWorksStatus) {
  EXPECT_EQ(Child([] { return 5; }).wait().status, 5);
  EXPECT_EQ(Child([]() -> int { ::abort(); }).wait().signal, SIGABRT);
}

TEST(Child, ACopyOfThisProcessNeverGoesOnAsThisProcess) {
  try {
    EXPECT_EQ(Child([]() -> int { throw std::runtime_error("in the copy"); }).wait().signal, SIGABRT);
  } catch (const std::runtime_error&) {
    ::_exit(0);  // ends the forked process, because only the parent may continue
  }
}

TEST(Child, OutputOfAProgramThatIsNotThereIsEmpty) {
  EXPECT_EQ(output_of({"echo", "some", "words"}), "some words\n");
  EXPECT_EQ(output_of({"/no/such/program"}), "");
}

#ifndef ROBOSIM_EMULATED  // qemu-user does not report that a program could not be started
TEST(Child, AProgramThatCannotBeStartedIsNamed) {
  ChildStart start;
  start.words = {"/no/such/program"};
  try {
    const Child child(start);
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_STREQ(error.what(), "/no/such/program cannot be started: No such file or directory");
  }
}
#endif

}  // namespace robosim::child_test
