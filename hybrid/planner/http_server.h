// HTTP on 127.0.0.1: who may ask, how much, and what becomes of it. What is answered is the
// session's.
#pragma once

#include <memory>
#include <string>

#include "planner/session.h"

namespace vasorod::planner {

/// A server with a fixed number of threads.
class HttpServer {
 public:
  explicit HttpServer(Session& session);
  ~HttpServer();

  /// Takes the port (0: a free one) of 127.0.0.1. Throws FileError where it is taken.
  void bind(int port);
  /// What the user opens.
  std::string url() const;
  /// Answers until stop().
  void run();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace vasorod::planner
