#include "core/call_end.h"

#include <exception>
#include <new>

#include "core/error.h"
#include "core/subject_errors.h"

namespace rasterproof {

CallEnd EndOf(const std::function<void()>& call) {
  try {
    call();
    return {};
  } catch (const SubjectDoesNotRun&) {
    throw;
  } catch (const SubjectRefusal& refusal) {
    return {Stop::kRefused, refusal.what()};
  } catch (const InputError& input) {
    return {Stop::kNotDrawable, input.what()};
  } catch (const SubjectHang& hang) {
    return {Stop::kHung, hang.what()};
  } catch (const SubjectFault& fault) {
    return {Stop::kBrokeDown, fault.what()};
  } catch (const SubjectDeadline& deadline) {
    return {Stop::kDeadline, deadline.what()};
  } catch (const SubjectTooSlow& slow) {
    return {Stop::kTooSlow, slow.what()};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& other) {
    return {Stop::kBrokeDown, std::string("it threw: ") + other.what()};
  } catch (...) {
    return {Stop::kBrokeDown, "it threw something that is no std::exception"};
  }
}

}  // namespace rasterproof
