#include "planner/http_server.h"

#include <charconv>
#include <httplib.h>
#include <vector>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "planner/address.h"
#include "planner/failure.h"
#include "planner/page_files.h"

namespace vasorod::planner {
namespace {

constexpr std::size_t longest_body = std::size_t{1} << 20;
constexpr std::size_t threads = 16;  // a browser holds six connections for each page it shows
constexpr int keep_alive_seconds = 2, read_seconds = 5, write_seconds = 10;
constexpr std::size_t requests_per_connection = 1000;
constexpr int waiting_connections = 128;

// The types with a charset are not compressed on the way: on one machine that would cost more time
// than it saves.
constexpr const char* json_type = "application/json; charset=utf-8";

void set_error(httplib::Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(
      Json{{"error", sentence}}.dump(-1, ' ', false, Json::error_handler_t::replace), json_type);
}

const char* type_of(const std::string& name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".js")) return "application/javascript; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "application/octet-stream";
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t end = std::min(path.find('/', from), path.size());
    parts.push_back(path.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

// What is behind the first `count` parts: names of vessels may have a slash.
std::string behind(const std::string& path, int count) {
  std::size_t from = 0;
  for (int k = 0; k < count; ++k) from = path.find('/', from) + 1;
  return path.substr(from);
}

int wait_of(const httplib::Request& request) {
  const std::string text = request.get_param_value("wait");
  if (text.empty()) return 0;
  int wait = 0;
  const char* end = text.data() + text.size();
  if (const auto read = std::from_chars(text.data(), end, wait);
      read.ec != std::errc() || read.ptr != end || wait < 0)
    throw Refusal(400, "wait: found " + in_quotes(text) + ", expected milliseconds from 0 on");
  return wait;
}

const char* word_of(int status) {
  switch (status) {
    case 400:
      return "found a request that is no HTTP, expected one of the page";
    case 404:
      return "found no such address, expected one of the page";
    case 413:
      return "found a body over 1 MB, expected a request of the page";
    case 414:
      return "found an address that is too long, expected one of the page";
    default:
      return "the request cannot be answered";
  }
}

}  // namespace

struct HttpServer::Parts {
  explicit Parts(Session& of) : session(of) {}

  void set_up();
  void require_friend(const httplib::Request& request) const;
  static void require_sound(const httplib::Request& request);
  void get(const httplib::Request& request, httplib::Response& response);
  void answer(const httplib::Request& request, httplib::Response& response);

  Session& session;
  Address address;
  httplib::Server server;
  socket_t listening = -1;
};

// What only our own page sends.
void HttpServer::Parts::require_friend(const httplib::Request& request) const {
  if (request.get_header_value_count("Host") != 1 ||
      !address.is_host(request.get_header_value("Host")))
    throw Refusal(403, "found a Host that is not this program's, expected its own address");
  for (std::size_t k = 0; k < request.get_header_value_count("Origin"); ++k)
    if (!address.is_origin(request.get_header_value("Origin", k)))
      throw Refusal(403, "found a page of another Origin, expected the program's own page");
  if (!address.below_token(request.path))
    throw Refusal(403, "found another address, expected the one that vasorod-plan printed");
}

// What a body may be, before any of it is read.
void HttpServer::Parts::require_sound(const httplib::Request& request) {
  if (request.method != "GET" && request.method != "HEAD" && request.method != "POST")
    throw Refusal(405, "found the method " + shortened(request.method) + ", expected GET or POST");
  if (request.has_header("Range"))
    throw Refusal(416, "found a Range, expected a request for the whole answer");
  if (request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding"))
    throw Refusal(415, "found an encoded body, expected plain JSON with its Content-Length");
  if (request.method != "POST") return;
  if (request.get_header_value_count("Content-Length") != 1)
    throw Refusal(411, "found no Content-Length, expected that of the body");
  const std::string type = request.get_header_value("Content-Type");
  if (type.substr(0, type.find(';')) != "application/json")
    throw Refusal(415, "Content-Type: found " + in_quotes(type) + ", expected application/json");
}

void HttpServer::Parts::get(const httplib::Request& request, httplib::Response& response) {
  const std::string path = address.below_token(request.path).value_or("");
  const std::vector<std::string> parts = parts_of(path);
  const auto json = [&](const Json& value) {
    response.set_content(value.dump(-1, ' ', false, Json::error_handler_t::replace), json_type);
  };
  const auto bytes = [&](std::string&& mesh) {
    response.set_content(std::move(mesh), "application/octet-stream");
  };
  if (parts[0] != "api") {
    const std::string name = path.empty() ? "index.html" : path;
    const std::string_view file = page_file(name);
    if (file.empty()) throw Refusal(404, word_of(404));
    response.set_content(file.data(), file.size(), type_of(name));
  } else if (path == "api/session") {
    json(session.about());
  } else if (path == "api/scene") {
    json(session.scene());
  } else if (parts.size() == 3 && parts[1] == "job") {
    json(session.job(parts[2], wait_of(request)));
  } else if (parts.size() == 3 && parts[1] == "result") {
    json(session.result(parts[2]));
  } else if (parts.size() >= 3 && parts[1] == "mesh") {
    bytes(session.mesh(behind(path, 2)));
  } else if (parts.size() >= 5 && parts[1] == "result" && parts[3] == "mesh") {
    bytes(session.result_mesh(parts[2], behind(path, 4)));
  } else {
    throw Refusal(404, word_of(404));
  }
}

void HttpServer::Parts::answer(const httplib::Request& request, httplib::Response& response) {
  try {
    if (request.method != "POST") {
      get(request, response);
      return;
    }
    const std::string path = address.below_token(request.path).value_or("");
    if (path.rfind("api/", 0) != 0) throw Refusal(404, word_of(404));
    const Json value = session.post(path.substr(4), Body(request.body));
    response.set_content(value.dump(-1, ' ', false, Json::error_handler_t::replace), json_type);
  } catch (...) {
    const Failure failure = failure_now();
    set_error(response, failure.status, failure.sentence);
  }
}

void HttpServer::Parts::set_up() {
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_payload_max_length(longest_body);
  server.set_keep_alive_timeout(keep_alive_seconds);
  server.set_keep_alive_max_count(requests_per_connection);
  server.set_read_timeout(read_seconds);
  server.set_write_timeout(write_seconds);
  server.set_tcp_nodelay(true);
  // Without SO_REUSEPORT, with which a second program would silently share the port.
  server.set_socket_options([this](socket_t socket) {
    listening = socket;
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  server.set_default_headers(
      {{"Cache-Control", "no-store"},
       {"X-Content-Type-Options", "nosniff"},
       {"Referrer-Policy", "no-referrer"},
       {"X-Frame-Options", "DENY"},
       {"Cross-Origin-Resource-Policy", "same-origin"},
       {"Content-Security-Policy",
        "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
        "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'"}});
  server.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        try {
          require_friend(request);
          require_sound(request);
          return httplib::Server::HandlerResponse::Unhandled;
        } catch (const Refusal& refusal) {
          set_error(response, refusal.status, refusal.what());
          return httplib::Server::HandlerResponse::Handled;
        }
      });
  const auto handler = [this](const httplib::Request& request, httplib::Response& response) {
    answer(request, response);
  };
  server.Get(".*", handler);
  server.Post(".*", handler);
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) set_error(response, response.status, word_of(response.status));
  });
  server.set_exception_handler(
      [](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
        set_error(response, 500, "the request cannot be answered");
      });
}

HttpServer::HttpServer(Session& session) : parts_(std::make_unique<Parts>(session)) {
  parts_->set_up();
}

HttpServer::~HttpServer() = default;

void HttpServer::bind(int port) {
  parts_->address.token = random_token();
  if (port == 0)
    parts_->address.port = parts_->server.bind_to_any_port("127.0.0.1");
  else
    parts_->address.port = parts_->server.bind_to_port("127.0.0.1", port) ? port : -1;
  if (parts_->address.port <= 0)
    throw FileError("port " + std::to_string(port) +
                    " of 127.0.0.1 is taken or may not be used, expected a free one (--port)");
  // The library lets five connections wait; the system answers more of them only seconds later.
  ::listen(parts_->listening, waiting_connections);
}

std::string HttpServer::url() const {
  return parts_->address.url();
}

void HttpServer::run() {
  parts_->server.listen_after_bind();
}

void HttpServer::stop() {
  parts_->server.stop();
}

}  // namespace vasorod::planner
