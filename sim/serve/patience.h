// How long a client may take to send a request, and how long the head of it may be. The HTTP library limits
// only the time from one byte to the next, so that a client that sends one now and then would keep one of its
// threads; and the length of a header, but not their number.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

namespace robosim::serve {

class Patience {
  struct Connection;

 public:
  /// `port`: where the server listens. `answer`: sent to who is too slow, before the connection is closed.
  Patience(int port, std::chrono::milliseconds most, std::string answer);
  ~Patience();

  /// The connection that has just been accepted: the library does not say which. Nothing where it is gone
  /// again.
  Connection* accepted();
  /// Answers its request, by `work`, in this thread; from now on it is awaited.
  void answer(Connection* connection, const std::function<void()>& work);

  // Of the connection that this thread answers:
  void head_is_here();
  void is_here();    ///< the request, as a whole
  void read_away();  ///< what comes of one that is answered already, or its sender would not see the answer

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection {
    int socket = -1;
    ino_t inode = 0;  // the number of a socket is used again
    Clock::time_point since{};
    bool awaited = false;
    bool head_awaited = false;
  };
  void watch();
  static bool floods(const Connection& one);

  static thread_local Connection* own_;

  const int port_;
  const std::chrono::milliseconds most_;
  const std::string answer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Connection> connections_;
  bool ends_ = false;
  std::thread watcher_;
};

}  // namespace robosim::serve
