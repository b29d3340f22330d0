#include <vasorod/version.h>

namespace vasorod {

std::string version() {
  return VASOROD_VERSION;
}

}  // namespace vasorod
