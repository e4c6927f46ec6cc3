// What explains wrong values: a mistake that gives every number that the subject shows.
#ifndef RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKES_H_
#define RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKES_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/subject.h"
#include "props/cause/evidence.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

/// A mistake that explains all numbers that were compared.
struct ValueMistake {
  std::string name;               ///< its section of docs/causes.md; empty: none was found
  std::vector<std::string> what;  ///< completes "a rasterizer that ..."; several: not told apart
  std::size_t numbers = 0;        ///< that were compared
  std::size_t wrong = 0;          ///< of these, numbers that are not what is stated
};

/// Whether a property of this is about numbers that a draw shows beside coverage.
bool IsAboutShownNumbers(Shows shows);

/// Has the subject show what the failed property asks for, of its cases and of others of the
/// property's domains, and compares what is shown with what each mistake would give. One number
/// that differs refutes a mistake. It is named if it explains wrong numbers of four cases or more.
///
/// Domain:     a property that asks for values, barycentrics, depths or derivatives of draws.
/// Returns:    no name after so many SecondsOfDraws without enough numbers.
ValueMistake FindValueMistake(Subject& subject, const FailedProperty& failure, double seconds);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKES_H_
