// A row of the tables of planted bugs and of legal variants.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "core/profile.h"
#include "subjects/mutants/centroids.h"
#include "subjects/mutants/clipping.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/free_choice.h"
#include "subjects/mutants/own_transform.h"
#include "subjects/mutants/real_geometry.h"
#include "subjects/mutants/shown_values.h"
#include "subjects/mutants/squares.h"
#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {

/// A sound base and what is different about it.
struct Mutant {
  std::string_view name;
  std::string_view change;  ///< completes "a sound rasterizer, but ..."
  std::string_view source;  ///< where it was met: a bug report, an API's rule; may be empty
  std::variant<FixedStages, RealStages, ClipStages, ValueStages, TransformStages, FreeStages,
               SquareStages, CentroidStages, ClippingStages, ChannelStages>
      stages;
  std::string_view causes = {};   ///< as MutantInfo::causes
  std::string_view killers = {};  ///< properties that each find it, with "|" between them
  /// Whether it is drawn in other floating-point modes, where only its bug shows.
  bool takes_float_modes = false;
};

/// Eight subpixel bits and four samples a pixel, on a rotated grid.
Profile FourSampleProfile();

/// Sound, under a preset.
FixedStages StagesOfPreset(std::string_view preset);

/// What the rows of a table are; Mutants() has them in this order.
enum class MutantKind : std::uint8_t {
  kPlanted,  ///< bugs
  kLate,     ///< bugs planted after the generators and the properties were frozen
  kLegal     ///< legal variants
};

/// The rows of one topic, which begins "extern constinit const MutantTable kItsTopicMutants{" in a
/// file beside this one whose name ends in "mutants" or "variants": the build lists the tables.
struct MutantTable {
  MutantKind kind;
  int place;  ///< among the tables of its kind, and no other's
  std::vector<Mutant> (*rows)();
};

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_
