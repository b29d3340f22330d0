#include <array>
#include <utility>

#include <vasorod/status.h>

namespace vasorod {
namespace {

constexpr std::array<std::pair<Status, const char*>, 8> names{{
    {Status::converged, "converged"},
    {Status::equilibrium_only, "equilibrium_only"},
    {Status::unstable, "unstable"},
    {Status::buckled, "buckled"},
    {Status::not_unique, "not_unique"},
    {Status::self_intersecting, "self_intersecting"},
    {Status::iteration_limit, "iteration_limit"},
    {Status::interrupted, "interrupted"},
}};

}  // namespace

std::string to_string(Status status) {
  for (const auto& [value, name] : names)
    if (value == status) return name;
  return {};
}

std::optional<Status> status_named(const std::string& name) {
  for (const auto& [value, text] : names)
    if (name == text) return value;
  return std::nullopt;
}

}  // namespace vasorod
