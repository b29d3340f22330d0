#include "planner/address.h"

#include <array>
#include <sys/random.h>

#include <vasorod/error.h>

namespace vasorod::planner {

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw FileError("found no source of random numbers, expected the system's (getrandom)");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

bool same_secret(const std::string& a, const std::string& b) {
  // No branch depends on a byte.
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^
                  static_cast<unsigned char>(b.empty() ? 0 : b[i % b.size()]);
  return difference == 0;
}

std::string Address::url() const {
  return "http://127.0.0.1:" + std::to_string(port) + "/" + token + "/";
}

bool Address::is_host(const std::string& host) const {
  constexpr int usual_port = 80;  // which browsers leave out
  if (port == usual_port && (host == "127.0.0.1" || host == "localhost")) return true;
  const std::string end = ":" + std::to_string(port);
  return host == "127.0.0.1" + end || host == "localhost" + end;
}

bool Address::is_origin(const std::string& origin) const {
  constexpr const char* scheme = "http://";
  return origin.rfind(scheme, 0) == 0 && is_host(origin.substr(7));
}

std::optional<std::string> Address::below_token(const std::string& path) const {
  if (path.empty() || path[0] != '/') return std::nullopt;
  const std::size_t end = path.find('/', 1);
  if (end == std::string::npos) return std::nullopt;
  if (!same_secret(path.substr(1, end - 1), token)) return std::nullopt;
  return path.substr(end + 1);
}

}  // namespace vasorod::planner
