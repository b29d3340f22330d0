#include "app/ending.h"

#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "predict/memory_need.h"

namespace vasorod {
namespace {

int say(const char* sentence, int exit_code) {
  std::cerr << "vasorod: " << sentence << std::endl;
  return exit_code;
}

int say_no_memory() {
  return say(
      "found no memory left, expected a scene that fits into it: fewer triangles or elements", 3);
}

}  // namespace

int say_failure() {
  try {
    throw;
  } catch (const StoppedEarly& error) {
    return say(error.what(), 1);
  } catch (const InputError& error) {
    return say(error.what(), 2);
  } catch (const FileError& error) {
    return say(error.what(), 3);
  } catch (const TooLarge& error) {
    return say(error.what(), 3);
  } catch (const std::bad_alloc&) {
    return say_no_memory();
  } catch (const std::length_error&) {  // thrown by containers for sizes beyond any memory
    return say_no_memory();
  } catch (const std::system_error& error) {
    // A thread could not be started because there is no memory for its stack.
    if (error.code() == std::errc::resource_unavailable_try_again) return say_no_memory();
    return say((std::string("unexpected: ") + error.what()).c_str(), 3);
  } catch (const std::exception& error) {
    return say((std::string("unexpected: ") + error.what()).c_str(), 3);
  }
}

}  // namespace vasorod
