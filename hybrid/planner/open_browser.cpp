#include "planner/open_browser.h"

#include <fcntl.h>
#include <initializer_list>
#include <sys/wait.h>
#include <unistd.h>

namespace vasorod::planner {

void open_browser(const std::string& url) {
  const pid_t child = fork();
  if (child < 0) return;
  if (child == 0) {
    // A grandchild, so that nobody has to wait for the browser.
    if (fork() != 0) _exit(0);
    setsid();
    const int null = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, stream);
    execlp("xdg-open", "xdg-open", url.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  waitpid(child, nullptr, 0);
}

}  // namespace vasorod::planner
