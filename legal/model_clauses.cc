#include "legal/model_clauses.h"

#include <algorithm>
#include <array>

#include "exact/edge.h"

namespace rasterproof::legal {

bool LiesOnEdge(Point2 a, Point2 b, Point2 p) {
  if (exact::EdgeSign(a, b, p) != 0) return false;
  const bool steep = a.x == b.x;
  const double from = steep ? a.y : a.x;
  const double to = steep ? b.y : b.x;
  const double here = steep ? p.y : p.x;
  return std::min(from, to) < here && here < std::max(from, to);
}

Literal ModelClauses::PlaceOf(std::size_t position, std::size_t place) {
  const std::size_t places = view_.choices().places[position].size();
  if (places == 1) return 0;
  std::vector<Literal>& variables = places_[position];
  if (variables.empty()) {
    for (std::size_t k = 0; k < places; ++k) variables.push_back(solver_.NewVariable());
    solver_.Add(variables);
    for (std::size_t i = 0; i < places; ++i) {
      for (std::size_t j = i + 1; j < places; ++j) solver_.Add({-variables[i], -variables[j]});
    }
  }
  return variables[place];
}

Literal ModelClauses::Covers(const OpenSample& open) {
  Literal& covers = covers_[&open];
  if (covers != 0) return covers;
  covers = solver_.NewVariable();
  std::vector<std::size_t> choice(open.corner.size());
  std::vector<Literal> clause;
  for (const Status status : open.by_choice) {
    if (status != Status::kFree) {
      clause.clear();
      for (std::size_t k = 0; k < choice.size(); ++k) {
        const Literal place = PlaceOf(view_.PositionOf(open.triangle, open.corner[k]), choice[k]);
        if (place != 0) clause.push_back(-place);
      }
      clause.push_back(status == Status::kIn ? covers : -covers);
      solver_.Add(clause);
    }
    for (std::size_t k = choice.size(); k-- > 0;) {  // the next choice
      if (++choice[k] < view_.PlacesOf(open.triangle, open.corner[k]).size()) break;
      choice[k] = 0;
    }
  }
  return covers;
}

void ModelClauses::AddExactlyOne(std::span<const Place> chosen, Literal first, Literal second) {
  std::vector<Literal> unless;
  for (const Place& one : chosen) {
    const Literal place = PlaceOf(view_.PositionOf(one.triangle, one.corner), one.place);
    if (place != 0) unless.push_back(-place);
  }
  std::vector<Literal> either = unless;
  either.insert(either.end(), {first, second});
  solver_.Add(either);
  unless.insert(unless.end(), {-first, -second});
  solver_.Add(unless);
}

void ModelClauses::AddOwner(const CommonEdgeSample& edge) {
  const std::size_t t = edge.first->triangle;
  const std::size_t u = edge.second->triangle;
  const std::size_t next = (edge.corner + 1) % 3;
  const std::size_t third = (edge.corner + 2) % 3;
  const std::vector<Point2>& from = view_.PlacesOf(t, edge.corner);
  const std::vector<Point2>& to = view_.PlacesOf(t, next);
  const Literal first = Covers(*edge.first);
  const Literal second = Covers(*edge.second);
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (!LiesOnEdge(from[i], to[j], edge.first->at)) continue;
      const std::array<Place, 2> ends{{{t, edge.corner, i}, {t, next, j}}};
      if (!edge.opposite) {
        AddExactlyOne(ends, first, second);
        continue;
      }
      const std::vector<Point2>& beside = view_.PlacesOf(t, third);
      const std::vector<Point2>& beyond = view_.PlacesOf(u, *edge.opposite);
      for (std::size_t k = 0; k < beside.size(); ++k) {
        const int side = exact::EdgeSign(from[i], to[j], beside[k]);
        for (std::size_t l = 0; l < beyond.size() && side != 0; ++l) {
          if (exact::EdgeSign(from[i], to[j], beyond[l]) != -side) continue;
          const std::array<Place, 4> all{{ends[0], ends[1], {t, third, k}, {u, *edge.opposite, l}}};
          AddExactlyOne(all, first, second);
        }
      }
    }
  }
}

void ModelClauses::AddExclusion(const Exclusion& exclusion, std::span<const OpenSample> open) {
  std::vector<Literal> otherwise;
  for (const auto& [sample, covered] : exclusion) {
    const Literal covers = Covers(open[sample]);
    otherwise.push_back(covered ? -covers : covers);
  }
  solver_.Add(otherwise);
}

// Sinz's sequential counter, in both directions.
Literal ModelClauses::Between(std::span<const Literal> literals, int least, int most) {
  const Literal active = solver_.NewVariable();
  const auto n = static_cast<int>(literals.size());
  if (least > n || most < 0 || least > most) {
    solver_.Add({-active});
    return active;
  }
  if (least <= 0 && most >= n) return active;
  if (n == 1) {
    solver_.Add({-active, least == 1 ? literals[0] : -literals[0]});
    return active;
  }
  // counted[j]: at least j + 1 of the literals so far.
  std::vector<Literal> counted;
  for (const Literal literal : literals) {
    std::vector<Literal> next;
    const std::size_t size = counted.size();
    for (std::size_t j = 0; j <= size; ++j) {
      const Literal now = solver_.NewVariable();
      next.push_back(now);
      if (j < size) {
        solver_.Add({-counted[j], now});
        solver_.Add({-now, counted[j], literal});
      } else {
        solver_.Add({-now, literal});
      }
      if (j > 0) {
        solver_.Add({-counted[j - 1], -literal, now});
        solver_.Add({-now, counted[j - 1]});
      } else {
        solver_.Add({-literal, now});
      }
    }
    counted = std::move(next);
  }
  if (least > 0) solver_.Add({-active, counted[static_cast<std::size_t>(least) - 1]});
  if (most < n) solver_.Add({-active, -counted[static_cast<std::size_t>(most)]});
  return active;
}

}  // namespace rasterproof::legal
