#include "predict/cause.h"

#include <new>
#include <stdexcept>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "predict/memory_need.h"

namespace vasorod {
namespace {

Cause no_memory() {
  return {Cause::Kind::system,
          "found no memory left, expected a scene that fits into it: fewer triangles or elements"};
}

}  // namespace

Cause cause_now() {
  using Kind = Cause::Kind;
  try {
    throw;
  } catch (const StoppedEarly& error) {
    return {Kind::stopped, error.what()};
  } catch (const InputError& error) {
    return {Kind::input, error.what()};
  } catch (const FileError& error) {
    return {Kind::system, error.what()};
  } catch (const TooLarge& error) {
    return {Kind::system, error.what()};
  } catch (const std::bad_alloc&) {
    return no_memory();
  } catch (const std::length_error&) {  // thrown by containers for sizes beyond any memory
    return no_memory();
  } catch (const std::system_error& error) {
    // A thread could not be started because there is no memory for its stack.
    if (error.code() == std::errc::resource_unavailable_try_again) return no_memory();
    return {Kind::system, std::string("unexpected: ") + error.what()};
  } catch (const std::exception& error) {
    return {Kind::system, std::string("unexpected: ") + error.what()};
  } catch (...) {
    return {Kind::system, "unexpected: an exception without words"};
  }
}

}  // namespace vasorod
