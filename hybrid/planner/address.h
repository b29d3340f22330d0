// Who may talk to the server: only what knows its address.
#pragma once

#include <optional>
#include <string>

namespace vasorod::planner {

/// 32 hexadecimal digits from the system's source of randomness. Throws FileError.
std::string random_token();

/// Whether two texts are the same, in a time that depends on their lengths alone.
bool same_secret(const std::string& a, const std::string& b);

/// Where the page is: http://127.0.0.1:PORT/TOKEN/.
struct Address {
  int port = 0;
  std::string token;

  std::string url() const;
  /// Whether a request's Host header names this server: a page of another name that was made to
  /// mean 127.0.0.1 (DNS rebinding) sends its own.
  bool is_host(const std::string& host) const;
  /// Whether a request's Origin header is this server's. Pages of others send theirs.
  bool is_origin(const std::string& origin) const;
  /// What follows /TOKEN/ in a request's path; empty where the token is another.
  std::optional<std::string> below_token(const std::string& path) const;
};

}  // namespace vasorod::planner
