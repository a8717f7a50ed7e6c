// Limits the time in which a client must send a request, and the length of the request's head. The HTTP
// library limits only the time between two bytes, so a client that sends bytes slowly would occupy a thread.
// The library limits the length of a header, but not the number of headers.
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

class RequestDeadline {
  struct Connection;

 public:
  /// `port` is the server's port. A client that needs longer than `most` gets `answer`, and its connection
  /// is closed.
  RequestDeadline(int port, std::chrono::milliseconds most, std::string answer);
  ~RequestDeadline();

  /// Finds the connection that the HTTP library has just accepted, because the library does not provide its
  /// socket. Returns null if the connection is already closed.
  Connection* accepted();
  /// Answers a connection's request by calling `work`, in this thread. The time limit starts now.
  void answer(Connection* connection, const std::function<void()>& work);

  // Report the progress of the connection that this thread answers.
  void head_is_here();
  void is_here();    ///< the whole request has arrived
  void read_away();  ///< reads input after the answer; otherwise the client would not get the answer

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection {
    int socket = -1;
    ino_t inode = 0;  // identifies the socket, because descriptors are reused
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
