#include "props/run/description.h"

#include "props/run/own_transform.h"

namespace rasterproof::props {

Description DescriptionOf(Subject& subject) {
  return {subject.Info(), subject.Edges(), subject.Barycentrics(), subject.Twin() != nullptr};
}

Description AsJudged(Description subject) {
  if (!OwnsTransform(subject.info)) return subject;
  subject.info = AsSeenByRecipes(subject.info);
  subject.edges = nullptr;
  subject.barycentrics = nullptr;
  return subject;
}

}  // namespace rasterproof::props
