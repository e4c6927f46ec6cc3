// The members of a bench file, each in one row: what writes the file and what reads it visit them.
#ifndef RASTERPROOF_REPORT_BENCH_MEMBERS_H_
#define RASTERPROOF_REPORT_BENCH_MEMBERS_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "core/bench_result.h"
#include "core/vertex.h"
#include "report/real_profile.h"

namespace rasterproof::report {

// How a number is written, where its type does not say so.
struct Rounded {
  double& number;  ///< to six digits; other doubles are as short as reads back to them
};
struct Exact {
  double& number;  ///< as a hexadecimal string
};
struct AsText {
  std::uint64_t& number;  ///< as a string: not every reader of JSON has 64 bits for a number
};
struct TargetSide {
  int& pixels;  ///< from 1 to kMaxTargetSide
};

// Values that are arrays of a fixed number of items, by their items.
inline auto ItemsOf(Interval& interval) {
  return std::tuple{Rounded{interval.low}, Rounded{interval.median}, Rounded{interval.high}};
}
inline auto ItemsOf(Vertex& v) {
  return std::tuple{Exact{v.x}, Exact{v.y}, Exact{v.z}, Exact{v.w}};
}
template <class T, std::size_t n>
auto ItemsOf(std::array<T, n>& items) {
  return std::apply([](auto&... item) { return std::tie(item...); }, items);
}
inline auto ErrorItems(BenchPoint& point) {
  return std::tuple_cat(std::tie(point.value, point.asked, point.wrong),
                        std::tuple{Rounded{point.displacement}, Rounded{point.share_of_bound}});
}
inline auto CostItems(BenchPoint& point) {
  return std::tuple_cat(std::tie(point.value, point.asked), ItemsOf(point.time));
}

// Members(visit, object) visits the members of an object in the order of the file:
//   visit(key, value)                    a member; of an optional, one that may be missing
//   visit.Each(key, list, as)            a list whose items are written as as(item)
//   visit.Index(key, index, list, what)  the name of an item of a list of the result
//   visit.Method(index)                  three members that name a method of the result
//   visit.Has(key, is_there)             whether a member is there, or is to be written
//   visit.result()                       the result to which the object belongs

void Members(auto& visit, BenchMethod& method) {
  visit("name", method.name);
  visit("summary", method.summary);
  visit("kind", method.kind);
  visit("target", method.target);
  visit("sink", method.sink);
  visit("model", method.model);
  visit("clock", method.clock);
  visit("proved", method.is_proved);
  visit("users", method.is_users);
  visit("coordinate_limit", method.coordinate_limit);
  visit("vertex_bytes", method.vertex_bytes);
  visit("pixel_bits", method.pixel_bits);
  visit("times_requests", method.times_requests);
  // What older files do not say.
  bool has_traits = !method.traversal.empty();
  if (visit.Has("traversal", has_traits)) {
    visit("traversal", method.traversal);
    visit("arithmetic", method.arithmetic);
    visit("space", method.space);
  }
  bool has_march = !method.march.empty();
  if (visit.Has("march", has_march)) visit("march", method.march);
}

void Members(auto& visit, BenchFamily& family) {
  visit("name", family.name);
  visit("summary", family.summary);
  visit("width", TargetSide{family.width});
  visit("height", TargetSide{family.height});
  visit("clip_space", family.is_clip_space);
  visit("constructed", family.is_constructed);
  visit("random", family.is_random);
  visit("largest_coordinate", family.largest_coordinate);
  visit("triangles", family.triangles);
  visit("covered", family.covered);
  visit("judged_triangles", family.judged_triangles);
  visit("judged_covered", family.judged_covered);
  visit("boundary_pairs", family.boundary_pairs);
  visit("shared_pairs", family.shared_pairs);
  visit("distances", family.distances.pairs);
  visit.Index("baseline", family.baseline, &BenchResult::methods, "method");
  visit.Index("twin", family.twin, &BenchResult::methods, "method");
  visit("rounds", family.rounds);
}

void Members(auto& visit, BenchWitness& witness) {
  visit("triangle", witness.triangle);
  visit("corners", witness.corners);
  visit("x", witness.x);
  visit("y", witness.y);
  visit("distance", witness.distance);
}

void Members(auto& visit, BenchErrors& errors) {
  visit("missing", errors.missing);
  visit("unexpected", errors.unexpected);
  visit("beside_edges", errors.beside_edges);
  visit("lost", errors.lost);
  visit("displacement", errors.displacement);
  visit("displacement_999", errors.displacement_999);
  visit("worst", errors.worst);
}

void JudgedMembers(auto& visit, BenchRow& row) {
  visit("real", row.real);
  // Against real geometry the two are one.
  bool has_own = visit.result().methods[row.method].model != kRealProfile;
  if (visit.Has("own", has_own)) {
    visit("own", row.own);
  } else {
    row.own = row.real;
  }
  visit("judged_triangles", row.judged_triangles);
  visit("boundary_pairs", row.boundary_pairs);
  visit("gaps", row.leaks.gaps);
  visit("overlaps", row.leaks.overlaps);
}

void Members(auto& visit, BenchRow& row) {
  visit.Index("family", row.family, &BenchResult::families, "family");
  visit.Method(row.method);
  visit("seconds", row.time);
  visit("wall_seconds", Rounded{row.wall_median});
  visit("ratio", row.ratio);
  visit("conversion_seconds", Rounded{row.conversion_seconds});
  visit("store_limit", row.binds_at_store);
  visit("drawing_wrong", row.drawing_wrong);
  if (visit.Has("real", row.is_judged)) JudgedMembers(visit, row);
  visit("edge_error", Rounded{row.values.edge});
  visit("edge_share_of_bound", Rounded{row.values.edge_share_of_bound});
  visit("barycentric_error", Rounded{row.values.barycentric});
  visit("depth_error", Rounded{row.values.depth});
  visit.Each("runs", row.seconds, [](double& seconds) { return Rounded{seconds}; });
}

void Members(auto& visit, BenchLeftOut& left_out) {
  visit.Index("family", left_out.family, &BenchResult::families, "family");
  visit.Method(left_out.method);
  visit("why", left_out.why);
}

void Members(auto& visit, BenchParameter& parameter) {
  visit("name", parameter.name);
  visit("summary", parameter.summary);
  visit("unit", parameter.unit);
  visit("cost", parameter.is_cost);
}

void Members(auto& visit, BenchCurve& curve) {
  visit.Method(curve.method);
  visit.Index("parameter", curve.parameter, &BenchResult::parameters, "parameter");
  if (visit.result().parameters[curve.parameter].is_cost) {
    visit.Each("points", curve.points, CostItems);
  } else {
    visit.Each("points", curve.points, ErrorItems);
  }
}

void Members(auto& visit, BenchCliff& cliff) {
  visit.Method(cliff.method);
  visit.Index("parameter", cliff.parameter, &BenchResult::parameters, "parameter");
  visit("proved_to", cliff.proved_to);
  visit("held_to", cliff.held_to);
  visit("first_failing", cliff.first_failing);
  visit("scene", cliff.scene);
  if (!cliff.scene) return;
  visit("x", cliff.x);
  visit("y", cliff.y);
}

void Members(auto& visit, BenchStage& stage) {
  visit("name", stage.name);
  visit("summary", stage.summary);
  visit("wrong", stage.wrong);
  visit("asked", stage.asked);
  visit("displacement", stage.displacement);
}

void Members(auto& visit, BenchFingerprint& print) {
  visit.Method(print.method);
  visit("step", print.step);
  visit("wrong", print.wrong);
  visit("png", print.png);
  visit("places", print.places);
}

void Members(auto& visit, ValueBenchFamily& family) {
  visit("name", family.name);
  visit("summary", family.summary);
  visit("clip_space", family.is_clip_space);
  visit("triangles", family.triangles);
  visit("covered", family.covered);
  visit("judged", family.judged);
  visit("floor_ns", Rounded{family.floor_ns});
}

void Members(auto& visit, ValueBenchCase& worst) {
  visit("corners", worst.corners);
  visit("x", worst.x);
  visit("y", worst.y);
  visit("shown", worst.shown);
  visit("exact", worst.exact);
}

void Members(auto& visit, ValueBenchRow& row) {
  visit.Index("family", row.family, &BenchResult::value_families, "family of values");
  visit("method", row.method);
  visit("target", row.target);
  visit("shows", row.shows);
  visit("ns_low", Rounded{row.ns_low});
  visit("ns", Rounded{row.ns});
  visit("ns_high", Rounded{row.ns_high});
  visit("ulps", Rounded{row.ulps});
  visit("ulps_999", Rounded{row.ulps_999});
  visit("texels", Rounded{row.texels});
  visit("texels_999", Rounded{row.texels_999});
  visit("share_of_bound", Rounded{row.share_of_bound});
  visit("unbounded", row.unbounded);
  visit("not_finite", row.not_finite);
  visit("worst", row.worst);
}

void Members(auto& visit, ValueBenchLimit& limit) {
  visit("parameter", limit.parameter);
  visit("method", limit.method);
  visit("target", limit.target);
  visit("held_to", limit.held_to);
  visit("fails_at", limit.fails_at);
}

/// Besides its members, the file begins with its version and has the decisions and claims after
/// `left_out`.
void Members(auto& visit, BenchResult& result) {
  visit.Version("rasterproof_bench");
  visit("processor", result.setting.processor);
  visit("compiler", result.setting.compiler);
  visit("flags", result.setting.flags);
  visit("commit", result.setting.commit);
  visit("command", result.setting.command);
  visit("date", result.setting.date);
  visit("seed", AsText{result.setting.seed});
  visit("quick", result.setting.is_quick);
  bool has_load = !std::isnan(result.setting.load_before);
  if (visit.Has("load_before", has_load)) {
    visit("load_before", Rounded{result.setting.load_before});
    visit("load_after", Rounded{result.setting.load_after});
  }
  visit("methods", result.methods);
  visit("families", result.families);
  visit("rows", result.rows);
  visit("left_out", result.left_out);
  bool lacks_some = !result.not_measured.empty();
  if (visit.Has("not_measured", lacks_some)) visit("not_measured", result.not_measured);
  visit.Decisions("decisions");
  visit.Claims("claims");
  visit("parameters", result.parameters);
  visit("curves", result.curves);
  visit("cliffs", result.cliffs);
  visit("stages", result.stages);
  visit("fingerprints", result.fingerprints);
  bool has_values = !result.value_families.empty();
  if (!visit.Has("value_families", has_values)) return;
  visit("value_families", result.value_families);
  visit("value_rows", result.value_rows);
  visit("value_limits", result.value_limits);
}

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_MEMBERS_H_
