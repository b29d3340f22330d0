#include "planner/result_shelf.h"

#include <algorithm>

#include "data/sentence.h"

namespace vasorod::planner {

namespace {

[[noreturn]] void refuse(const std::string& id) {
  throw Refusal(404, "found no result " + in_quotes(id) + ", expected one of the last " +
                         std::to_string(ResultShelf::most));
}

}  // namespace

std::string ResultShelf::next_id() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return "r" + std::to_string(++count_);
}

void ResultShelf::put(std::shared_ptr<const StoredResult> result) {
  std::shared_ptr<const StoredResult> oldest;  // freed after the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  results_.push_back(std::move(result));
  if (results_.size() > most) {
    oldest = std::move(results_.front());
    results_.pop_front();
  }
}

std::shared_ptr<const StoredResult> ResultShelf::find(const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto* shelf : {&held_, &results_})
    for (const auto& result : *shelf)
      if (result->id == id) return result;
  refuse(id);
}

void ResultShelf::hold(const std::string& id, bool hold) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& from = hold ? results_ : held_;
  auto& to = hold ? held_ : results_;
  const auto called = [&](const auto& result) { return result->id == id; };
  const auto found = std::find_if(from.begin(), from.end(), called);
  if (found == from.end()) {
    if (std::none_of(to.begin(), to.end(), called)) refuse(id);
    return;
  }
  if (hold && held_.size() >= most)
    throw Refusal(409, "found " + std::to_string(most) +
                           " results that are held, expected one of them to be let go first");
  to.push_back(*found);
  from.erase(found);
  if (results_.size() > most) results_.pop_front();
}

}  // namespace vasorod::planner
