#include "core/call_end.h"

#include <exception>
#include <new>

namespace rasterproof {

CallEnd EndOf(const std::function<void()>& call) {
  try {
    call();
    return {};
  } catch (const SubjectDoesNotRun&) {
    throw;
  } catch (const SubjectStop& stop) {
    return {stop.stop(), stop.what()};
  } catch (const InputError& input) {
    return {Stop::kNotDrawable, input.what()};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& other) {
    return {Stop::kBrokeDown, std::string("it threw: ") + other.what()};
  } catch (...) {
    return {Stop::kBrokeDown, "it threw something other than a std::exception"};
  }
}

}  // namespace rasterproof
