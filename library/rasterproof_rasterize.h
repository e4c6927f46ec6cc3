/* Exact coverage as a library, in C: what library/rasterize.h says, without exceptions.
 *
 * C99 and C++11. Every call returns a status; the message of a thread's last call that failed is
 * rasterproof_raster_message(). A call that fails has drawn nothing; spans may have been given
 * before STOPPED and FAULT. While a call draws, and in its callback, the thread's floating-point
 * environment is the default one (no flush to zero); then it is what it was. Link
 * rasterproof::rasterize, by a C++ linker.
 */
#ifndef RASTERPROOF_LIBRARY_RASTERPROOF_RASTERIZE_H_
#define RASTERPROOF_LIBRARY_RASTERPROOF_RASTERIZE_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header; rasterproof_raster_version() is the library's. They must be equal. */
#define RASTERPROOF_RASTER_VERSION 3u
uint32_t rasterproof_raster_version(void);

typedef enum rasterproof_raster_status {
  RASTERPROOF_RASTER_OK = 0,
  RASTERPROOF_RASTER_BAD_ARGUMENT = 1, /* the message names it, and the remedy */
  RASTERPROOF_RASTER_STOPPED = 2,      /* the callback said so */
  RASTERPROOF_RASTER_NO_MEMORY = 3,
  RASTERPROOF_RASTER_FAULT = 4 /* an exception of a callback in C++, threads that can't be started,
                                  or a fault of the library */
} rasterproof_raster_status;

/* The data kept of covered pixels: see RasterOutput. */
enum rasterproof_raster_output {
  RASTERPROOF_RASTER_COUNTS = 0,        /* uint8_t, 255 at most */
  RASTERPROOF_RASTER_FACING_COUNTS = 1, /* uint32_t: front in `memory`, others in `back` */
  RASTERPROOF_RASTER_MASK = 2,          /* a bit, pixel x at bit x & 7 of byte x >> 3 */
  RASTERPROOF_RASTER_IDS = 3,           /* uint32_t: the last triangle */
  RASTERPROOF_RASTER_DEPTHS = 4,        /* float: the least z, within the vertices' */
  RASTERPROOF_RASTER_INNER_MASK = 5,  /* a bit, only if the mesh covers all of the pixel's square */
  RASTERPROOF_RASTER_OUTER_MASK = 6,  /* a bit: a triangle meets the pixel's open square */
  RASTERPROOF_RASTER_INNER_DEPTHS = 7 /* float: of INNER_MASK's pixels, the greatest z there */
};
#define RASTERPROOF_RASTER_NO_TRIANGLE 0xffffffffu

/* `set` below. */
enum rasterproof_raster_set {
  RASTERPROOF_RASTER_BEST = 0,
  RASTERPROOF_RASTER_SCALAR = 1,
  RASTERPROOF_RASTER_SSE4 = 2,
  RASTERPROOF_RASTER_AVX2 = 3,
  RASTERPROOF_RASTER_AVX512 = 4,
  RASTERPROOF_RASTER_NEON = 5
};

/* `space` below. Clip space is scaled to the viewport: (x / w, y / w) is a vertex's place in the
 * window. Of clip coordinates (X, Y, z, w), Y up, that is x = (w + X) width / 2 and
 * y = (w - Y) height / 2. Depths are z / w. Vertices may lie at or behind the eye; a triangle with
 * a NaN or an infinity in x, y or w, or in z where there is a near plane, covers nothing. There is
 * no far plane, and no output of squares. */
enum rasterproof_raster_space {
  RASTERPROOF_RASTER_WINDOW = 0, /* pixels, x right, y down; pixel (i, j) has its centre at
                                    (i + 1/2, j + 1/2) */
  RASTERPROOF_RASTER_CLIP = 1,   /* scaled to the viewport, any sign of w, without a near plane */
  RASTERPROOF_RASTER_CLIP_NEAR_ZERO = 2,   /* 0 <= z: Vulkan, Direct3D */
  RASTERPROOF_RASTER_CLIP_NEAR_MINUS_W = 3 /* -w <= z: OpenGL */
};

/* Positions and indices are aligned to 4 bytes and do not overlap the target's memory. */
typedef struct rasterproof_raster_mesh {
  const float* positions; /* x, y, z of each vertex; in clip space x, y, z, w */
  size_t vertex_count;
  const uint32_t* indices; /* three of each triangle */
  size_t triangle_count;
  uint32_t space; /* enum rasterproof_raster_space */
} rasterproof_raster_mesh;

/* Memory of the caller's, rows from the top. */
typedef struct rasterproof_raster_target {
  uint32_t output; /* enum rasterproof_raster_output */
  int32_t width;
  int32_t height;
  size_t pitch; /* bytes from one row to the next */
  void* memory;
  size_t memory_size; /* bytes */
  void* back;         /* NULL unless the output is FACING_COUNTS */
  size_t back_size;
} rasterproof_raster_target;

/* A run of pixels that a triangle covers: columns [x0, x1) of row y. */
typedef struct rasterproof_raster_span {
  uint32_t triangle;
  int32_t is_front; /* 1: counter-clockwise, as seen on the screen */
  int32_t y;
  int32_t x0;
  int32_t x1;
} rasterproof_raster_span;

/* 0: go on; anything else ends the drawing. */
typedef int32_t (*rasterproof_raster_on_span)(void* state, const rasterproof_raster_span* span);

/* Empties every pixel. */
rasterproof_raster_status rasterproof_raster_clear(const rasterproof_raster_target* target);

/* Draws the triangles in order onto the contents of memory. */
rasterproof_raster_status rasterproof_rasterize(const rasterproof_raster_mesh* mesh,
                                                const rasterproof_raster_target* target,
                                                uint32_t set);

/* Threads that draw a mesh together: bit for bit what rasterproof_rasterize draws. One call at a
 * time; 1 to 256, the calling thread among them. Destroy takes NULL. */
typedef struct rasterproof_raster_workers rasterproof_raster_workers;
rasterproof_raster_status rasterproof_raster_workers_create(uint32_t count,
                                                            rasterproof_raster_workers** workers);
void rasterproof_raster_workers_destroy(rasterproof_raster_workers* workers);
rasterproof_raster_status rasterproof_raster_workers_rasterize(
    rasterproof_raster_workers* workers, const rasterproof_raster_mesh* mesh,
    const rasterproof_raster_target* target, uint32_t set);

/* Calls on_span for every row of every triangle that is covered, in order. */
rasterproof_raster_status rasterproof_rasterize_spans(const rasterproof_raster_mesh* mesh,
                                                      int32_t width, int32_t height,
                                                      rasterproof_raster_on_span on_span,
                                                      void* state, uint32_t set);

/* `interpolation` and `rounding` below: see RasterInterpolation and RasterRounding. */
enum rasterproof_raster_interpolation {
  RASTERPROOF_RASTER_PERSPECTIVE = 0, /* of the triangle before the division by w */
  RASTERPROOF_RASTER_LINEAR = 1       /* of its picture on the screen: noperspective */
};
enum rasterproof_raster_rounding {
  RASTERPROOF_RASTER_FAST = 0,   /* in float, within kValueConditions of rasterize.h */
  RASTERPROOF_RASTER_NEAREST = 1 /* the nearest float, ties to even; no derivatives */
};

/* Numbers of the vertices, and memory for those of the pixels: row y of channel c begins at number
 * (c height + y) pitch of each plane. FAST takes numbers of at most 2^100, and at least 2^-100 or
 * 0; NEAREST any finite ones. Where a vertex has a NaN or an infinity the triangle shows NaN. */
typedef struct rasterproof_raster_values {
  const float* numbers; /* `channels` of each vertex of the mesh */
  uint32_t channels;    /* 1 to 64 */
  uint32_t interpolation;
  uint32_t rounding;
  int32_t width; /* pixels, as height */
  int32_t height;
  size_t pitch; /* numbers from one row to the next, at least width */
  float* values;
  float* dx; /* d/dx and d/dy, a pixel; both or NULL */
  float* dy;
  size_t size; /* numbers in each plane: ((channels height) - 1) pitch + width at least */
} rasterproof_raster_values;

/* Writes the numbers of each covered pixel, of the last triangle that covers it; others stay as
 * they are. BAD_ARGUMENT for what the above does not allow, or planes that overlap the mesh. */
rasterproof_raster_status rasterproof_rasterize_values(const rasterproof_raster_mesh* mesh,
                                                       const rasterproof_raster_values* values,
                                                       uint32_t set);

/* Writes 1 for each triangle that covers no pixel centre, 0 for each that does: a byte each. */
rasterproof_raster_status rasterproof_raster_mark_empty(const rasterproof_raster_mesh* mesh,
                                                        int32_t width, int32_t height,
                                                        uint8_t* is_empty, uint32_t set);

/* Bytes of memory (and of back) with which nothing is copied; 0 if the target is NULL. */
size_t rasterproof_raster_room(const rasterproof_raster_target* target);

/* 1 if this machine, and this build of the library, runs the set. */
int32_t rasterproof_raster_is_supported(uint32_t set);

/* Of this thread's last call that failed; "" before that. It stays until the next one fails. */
const char* rasterproof_raster_message(void);

#ifdef __cplusplus
}
#endif

#endif /* RASTERPROOF_LIBRARY_RASTERPROOF_RASTERIZE_H_ */
