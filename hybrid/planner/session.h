// What the page asks for, answered: the opened scene or result, picks, solves, results.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "planner/result_shelf.h"
#include "planner/solve_jobs.h"
#include "planner/sources.h"

namespace vasorod::planner {

/// Everything of a running program. Its functions may be called by several threads at once. They
/// throw Refusal and what the library throws (failure.h).
class Session {
 public:
  /// Finds the sources; opens nothing. Throws InputError.
  Session(const std::vector<std::filesystem::path>& named, const std::filesystem::path& working);

  /// GET api/session, with what was written beside the scenes since.
  Json about();
  /// GET api/scene. Opens the first source where nothing is open.
  Json scene();
  /// POST api/open, pick, place, solve, cancel, section, save, keep, hold.
  Json post(const std::string& what, const Body& body);
  /// GET api/job/ID.
  Json job(const std::string& id, int wait_ms);
  /// GET api/result/ID.
  Json result(const std::string& id) const;
  /// GET api/mesh/NAME.
  std::string mesh(const std::string& vessel);
  /// GET api/result/ID/mesh/NAME.
  std::string result_mesh(const std::string& id, const std::string& body) const;

 private:
  /// A scene or a result.
  struct Opened {
    std::string id, name;
    std::shared_ptr<const OpenedScene> scene;
    std::shared_ptr<const StoredResult> result;
  };

  std::shared_ptr<const Opened> open(const std::string& id);
  std::shared_ptr<const Opened> current();
  std::shared_ptr<const OpenedScene> current_scene();
  std::shared_ptr<const StoredResult> stored(const std::string& id) const;
  Json scene_of(const Opened& opened) const;

  Json pick(const Body& body);
  Json place(const Body& body);
  Json solve(const Body& body);
  Json section(const Body& body);
  Json save(const Body& body);
  Json keep(const Body& body);

  std::filesystem::path folder_;
  std::mutex opening_;        // one at a time
  mutable std::mutex mutex_;  // of what follows
  std::vector<Source> sources_;
  std::shared_ptr<const Opened> current_;
  ResultShelf shelf_;
  SolveJobs jobs_;
};

}  // namespace vasorod::planner
