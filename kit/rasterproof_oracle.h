/* The oracle in C: what a correct rasterizer covers, decided exactly.
 *
 * C99 and C++11. Link librasterproof_oracle, shared or static: neither CGAL nor GMP is in it. Every
 * call may come from any thread, sets the thread's floating-point environment to the default one
 * while it runs, and then puts back what was there.
 *
 * Coordinates are doubles, taken as exact numbers: pixels, x to the right; y as the profile says,
 * downwards unless it says otherwise. Arrays of samples are row-major
 * [height][width][samples of a pixel], the top row first. Sample s of a pixel is the profile's
 * sample_locations[s]: of one sample the centre, unless the profile says otherwise.
 */
#ifndef RASTERPROOF_KIT_RASTERPROOF_ORACLE_H_
#define RASTERPROOF_KIT_RASTERPROOF_ORACLE_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define RASTERPROOF_ORACLE_API __attribute__((visibility("default")))
#else
#define RASTERPROOF_ORACLE_API
#endif

/* Of this header; rasterproof_oracle_version() is the library's. They must be equal. */
#define RASTERPROOF_ORACLE_VERSION 1u
RASTERPROOF_ORACLE_API uint32_t rasterproof_oracle_version(void);

/* What a call comes to. One that does not come to OK has written nothing. */
typedef enum rasterproof_oracle_status {
  RASTERPROOF_ORACLE_OK = 0,
  RASTERPROOF_ORACLE_BAD_ARGUMENT = -1, /* the message names it, and the remedy */
  RASTERPROOF_ORACLE_NOT_DECIDED = -2,  /* the profile states nothing of it: the message says why */
  RASTERPROOF_ORACLE_NO_MEMORY = -3,
  RASTERPROOF_ORACLE_FAULT = -4 /* a fault of the library, or a build that can't be exact */
} rasterproof_oracle_status;

/* What legal rasterizers do with a sample and a triangle. */
enum rasterproof_oracle_decision {
  RASTERPROOF_ORACLE_MUST_NOT = 0, /* none covers it */
  RASTERPROOF_ORACLE_MUST = 1,     /* all cover it */
  RASTERPROOF_ORACLE_MAY = 2       /* some do and some don't */
};

enum rasterproof_oracle_verdict {
  RASTERPROOF_ORACLE_LEGAL = 0,     /* one legal rasterizer draws all of it */
  RASTERPROOF_ORACLE_NOT_LEGAL = 1, /* none does: the message says why */
  RASTERPROOF_ORACLE_NOT_JUDGED = 2 /* none was found, and the search was given up */
};

/* Of this thread's last call that did not come to OK, or that found a drawing not legal; "" before
 * that. It stays until the next one. */
RASTERPROOF_ORACLE_API const char* rasterproof_oracle_message(void);

/* ---- A profile: what a rasterizer states ---- */

/* Never changes once it is open: threads may share it. */
typedef struct rasterproof_oracle_profile rasterproof_oracle_profile;

/* Opens a preset by its name ("vulkan", "d3d11-canonical", "real"), or the text of a profile, JSON
 * ({"name": "mine", "subpixel_bits": 4, "snap_rule": "floor"}); docs/subjects.md has all keys. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status
rasterproof_oracle_open(const char* text_or_preset, rasterproof_oracle_profile** opened);

/* NULL is allowed. */
RASTERPROOF_ORACLE_API void rasterproof_oracle_close(rasterproof_oracle_profile* profile);

/* Samples of a pixel; 0 if the profile is NULL. */
RASTERPROOF_ORACLE_API int32_t
rasterproof_oracle_samples(const rasterproof_oracle_profile* profile);

/* Moves a point to where the profile's canonical model places a vertex on a target of that size. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status
rasterproof_oracle_place(const rasterproof_oracle_profile* profile, int32_t width, int32_t height,
                         double x, double y, double* placed_x, double* placed_y);

/* ---- Scenes ---- */

typedef struct rasterproof_oracle_scene {
  int32_t width; /* of the target, in pixels: 1 to 65536 */
  int32_t height;
  int32_t clip_space;     /* 0: window space, w is 1. 1: scaled clip space, window = x/w, y/w */
  const double* vertices; /* x, y, z, w of each */
  size_t vertex_count;
  const int32_t* triangles; /* three indices of each */
  size_t triangle_count;
} rasterproof_oracle_scene;

/* How many triangles of each facing the profile's canonical model counts at each sample. Front is
 * positive area: counter-clockwise on the screen. `size` is the number of elements of each array,
 * height * width * samples. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status rasterproof_oracle_counts(
    const rasterproof_oracle_profile* profile, const rasterproof_oracle_scene* scene,
    uint32_t* front, uint32_t* back, size_t size);

/* What legal rasterizers do with each triangle alone: an enum rasterproof_oracle_decision for each
 * [triangle][row][column][sample]. `size` is triangle_count * height * width * samples.
 *
 * Decisions are each by itself: of two neighbours a sample on their edge may be MAY for both, and
 * exactly one covers it. rasterproof_oracle_judge() judges them together. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status
rasterproof_oracle_decide(const rasterproof_oracle_profile* profile,
                          const rasterproof_oracle_scene* scene, uint8_t* decisions, size_t size);

/* How often legal rasterizers cover each sample, at least and at most. Equal: it is decided. Counts
 * beyond 63 are told as 63. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status rasterproof_oracle_bounds(
    const rasterproof_oracle_profile* profile, const rasterproof_oracle_scene* scene,
    uint32_t* least, uint32_t* most, size_t size);

/* Whether one legal rasterizer draws all of this: `counts` is how many triangles cover each sample,
 * facings together; with is_mask 1 only whether any does. *verdict is one of
 * rasterproof_oracle_verdict. For a profile with one model this is equality. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status rasterproof_oracle_judge(
    const rasterproof_oracle_profile* profile, const rasterproof_oracle_scene* scene,
    const uint32_t* counts, size_t size, int32_t is_mask, int32_t* verdict);

/* ---- Single questions, of numbers alone: for DPI-C and any foreign-function interface ---- */

/* Whether legal rasterizers of the profile cover sample s of the pixel in that column and row, for
 * one triangle: an enum rasterproof_oracle_decision, or a status below 0. */
RASTERPROOF_ORACLE_API int32_t rasterproof_oracle_covers(const rasterproof_oracle_profile* profile,
                                                         int32_t width, int32_t height, double x0,
                                                         double y0, double x1, double y1, double x2,
                                                         double y2, int32_t column, int32_t row,
                                                         int32_t s);

/* Sign of E(a, b; p) = (px - ax)(by - ay) - (py - ay)(bx - ax): 1 if a, b, p turn
 * counter-clockwise on the screen, -1 if clockwise, 0 if they are collinear, 2 if a coordinate is
 * not finite. */
RASTERPROOF_ORACLE_API int32_t rasterproof_oracle_edge_sign(double ax, double ay, double bx,
                                                            double by, double px, double py);

/* The three barycentrics of p, each rounded once to the nearest double: E of the edge opposite
 * vertex k, over E(v0, v1; v2). NOT_DECIDED if the triangle has no area. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status
rasterproof_oracle_barycentrics(double x0, double y0, double x1, double y1, double x2, double y2,
                                double px, double py, double* b0, double* b1, double* b2);

/* What numbers at a triangle's corners are at p, and their derivatives by x and y, each rounded
 * once to the nearest double. `corners` are x, y, w of the three, the window's being (x/w, y/w); w
 * may have any sign (1 in window space). `numbers` are one a corner. `interpolation`: 1 affine on
 * the screen, 2 in perspective, 3 the number over w (1/w of the numbers 1, a depth of the corners'
 * z). `by_x` and `by_y` may be NULL. NOT_DECIDED if the triangle has no area, or p lies on its
 * horizon. */
RASTERPROOF_ORACLE_API rasterproof_oracle_status
rasterproof_oracle_value(const double corners[9], const double numbers[3], int32_t interpolation,
                         double px, double py, double* value, double* by_x, double* by_y);

#ifdef __cplusplus
}
#endif

#endif /* RASTERPROOF_KIT_RASTERPROOF_ORACLE_H_ */
