/* A rasterizer as a shared library: the function that it exports and the data that it receives.
 *
 * A library exports one function, rasterproof_plugin_describe(), which returns a description of
 * itself with pointers to its calls. Only `draw` is required. `rasterproof check --plugin
 * ./libmine.so` loads it in a separate process: a crash, a hang or a write outside the target is
 * a finding with its case, not the end of the run.
 *
 * C11 and C++. Version 2. Structures grow at their end only, and `size` states their length, so a
 * library that was built against an older header goes on working.
 */
#ifndef RASTERPROOF_KIT_RASTERPROOF_PLUGIN_H_
#define RASTERPROOF_KIT_RASTERPROOF_PLUGIN_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define RASTERPROOF_PLUGIN_VERSION 2u

/* The form in which the library returns coverage. */
enum rasterproof_coverage {
  /* front and back: how many triangles of each facing cover the sample. Front is counter-clockwise
   * as seen on the screen. */
  RASTERPROOF_FACING_COUNTS = 0,
  /* front alone: how many triangles cover the sample. */
  RASTERPROOF_COUNTS = 1,
  /* front alone: 1 where anything covers the sample. Triangles then come one to a call, so that
   * overlaps still show. */
  RASTERPROOF_MASK = 2,
  /* primitive ids: which triangle is visible at each sample, as `visible` says. front is NULL. */
  RASTERPROOF_PRIMITIVE_IDS = 3,
  /* primitive ids, and barycentrics and depths of the visible triangle at each sample. front is
   * NULL. */
  RASTERPROOF_FRAGMENTS = 4
};

/* Which of several triangles on a sample is visible. */
enum rasterproof_visible { RASTERPROOF_LAST_DRAWN = 0, RASTERPROOF_FIRST_DRAWN = 1 };

/* The vertices that barycentrics belong to: as given, or on the profile's subpixel grid. EITHER:
 * nothing is stated, and each triangle is judged by the vertices that its barycentrics fit. */
enum rasterproof_barycentrics_of {
  RASTERPROOF_OF_EITHER = 0,
  RASTERPROOF_OF_SNAPPED = 1,
  RASTERPROOF_OF_GIVEN = 2
};

/* The number format in which the library computes its input. */
enum rasterproof_input {
  RASTERPROOF_FLOAT32 = 0, /* every coordinate is a float */
  RASTERPROOF_FLOAT64 = 1,
  RASTERPROOF_FIXED = 2 /* every x and y is a multiple of 2^-fixed_fraction_bits; window space */
};

/* Options that the library takes and outputs that it shows, as bits of rasterproof_plugin.takes.
 * None of them: window-space scenes, drawn whole. */
#define RASTERPROOF_TAKES_CLIP_SPACE 1u      /* scenes with w; without this bit w is 1 */
#define RASTERPROOF_TAKES_NO_WINDOW_SPACE 2u /* nothing but scenes with w */
#define RASTERPROOF_TAKES_CULLING 4u
#define RASTERPROOF_TAKES_SCISSOR 8u
#define RASTERPROOF_TAKES_TILES 16u
#define RASTERPROOF_TAKES_THREADS 32u
/* rasterproof_target.wants is read: barycentrics and depths that it does not name are NULL. */
#define RASTERPROOF_TAKES_WANTS 64u
/* rasterproof_target.centroids is read, and written if it is not NULL. For FRAGMENTS. */
#define RASTERPROOF_SHOWS_CENTROIDS 128u
/* Another processor draws: only elapsed time measures it. */
#define RASTERPROOF_DRAWS_ELSEWHERE 256u
/* rasterproof_scene.channels are read, and rasterproof_target.values, and with the second bit
 * derivatives too, are written where they are not NULL. For FRAGMENTS. */
#define RASTERPROOF_SHOWS_VALUES 512u
#define RASTERPROOF_SHOWS_DERIVATIVES 1024u

/* Requested outputs in addition to primitive ids, as bits of rasterproof_target.wants. */
#define RASTERPROOF_WANTS_BARYCENTRICS 1u
#define RASTERPROOF_WANTS_DEPTHS 2u
#define RASTERPROOF_WANTS_VALUES 4u
#define RASTERPROOF_WANTS_DERIVATIVES 8u

enum rasterproof_cull {
  RASTERPROOF_CULL_NONE = 0,
  RASTERPROOF_CULL_FRONT = 1,
  RASTERPROOF_CULL_BACK = 2
};

/* How the numbers at a triangle's vertices become one at a point. */
enum rasterproof_interpolation {
  RASTERPROOF_FLAT = 0,        /* the provoking vertex's number */
  RASTERPROOF_LINEAR = 1,      /* affine on the screen (noperspective) */
  RASTERPROOF_PERSPECTIVE = 2, /* affine before the division by w */
  RASTERPROOF_INVERSE_W = 3    /* 1/w at the point; there are no numbers at the vertices */
};

/* Where in its pixel a value is evaluated: at each covered sample, at the pixel's centre, or at the
 * centroid that the profile states. */
enum rasterproof_at {
  RASTERPROOF_AT_SAMPLE = 0,
  RASTERPROOF_AT_CENTRE = 1,
  RASTERPROOF_AT_CENTROID = 2
};

typedef struct rasterproof_channel {
  const char* name;
  int32_t interpolation; /* enum rasterproof_interpolation */
  int32_t at;            /* enum rasterproof_at */
  const double* values;  /* one a vertex; floats exactly, unless the input is FLOAT64 */
} rasterproof_channel;

/* A mesh to draw. Window space: pixels, x right, y down (unless the profile says up), pixel (i, j)
 * has its centre at (i + 1/2, j + 1/2). Clip space: x and y are scaled to the viewport already
 * (window = x/w, y/w). */
typedef struct rasterproof_scene {
  uint32_t size; /* sizeof(rasterproof_scene) of the caller */
  int32_t width;
  int32_t height;
  int32_t clip_space;       /* 0: window space, every w is 1 */
  const double* vertices;   /* 4 a vertex: x, y, z, w; floats exactly, where the input is FLOAT32 */
  const int32_t* triangles; /* 3 indices a triangle */
  size_t vertex_count;
  size_t triangle_count;
  int32_t cull;       /* enum rasterproof_cull */
  int32_t scissor[4]; /* x0, y0, x1, y1: columns [x0, x1), rows [y0, y1) from the top */
  int32_t tile;       /* 0: the library's own choice */
  int32_t threads;    /* 0: the library's own choice */
  /* Where the input is FIXED: 2 a vertex, x and y in units of 2^-fixed_fraction_bits; not wrapped.
   * Else NULL. The vertices hold the same places. */
  const int64_t* fixed;
  /* What to interpolate; none unless values are wanted. Where `size` ends before them, there are
   * none. */
  const rasterproof_channel* channels;
  size_t channel_count;
} rasterproof_scene;

/* Where the answer goes: row-major, top row first, `samples` entries a pixel. Add to the counts
 * there. A row's samples end before `stride`: memory between, before and after rows is guarded.
 * Rows of barycentrics are 3 * stride apart. */
typedef struct rasterproof_target {
  uint32_t size; /* sizeof(rasterproof_target) of the caller */
  int32_t samples;
  size_t stride; /* samples from one row to the next */
  uint32_t* front;
  uint32_t* back; /* NULL unless the coverage is FACING_COUNTS */
  /* NULL unless the coverage is PRIMITIVE_IDS or FRAGMENTS. Full of -1: no triangle. */
  int32_t* primitive_ids;
  /* NULL unless the coverage is FRAGMENTS; see RASTERPROOF_TAKES_WANTS. Entries 3 k to 3 k + 2 are
   * the barycentric coordinates of sample k, for the visible triangle's vertices. */
  double* barycentrics;
  /* The visible triangle's z at the sample; the z of vertices asked about lie in [0, 1]. */
  double* depths;
  /* RASTERPROOF_WANTS_... Barycentrics and depths that are there and not named need not be written.
   * Primitive ids are always: coverage is read off them. */
  uint32_t wants;
  /* NULL unless the library shows centroids and they are looked at. Laid out as barycentrics: those
   * of the visible triangle where attributes asked for at the centroid of its fragment in this
   * pixel are evaluated. Where `size` ends before it, it is not there. */
  double* centroids;
  /* NULL unless the library shows values and they are wanted. Entry channel_count k + c is channel
   * c of the visible triangle at sample k; rows are channel_count * stride apart. */
  double* values;
  /* Likewise, two for each value: its derivatives by x and by y, in the window's axes, a pixel
   * being 1. */
  double* derivatives;
} rasterproof_target;

/* Steps along a row (along_y 0) or a column (1): `steps` steps of `length` pixels, forward (sign
 * +1) or back (-1). */
typedef struct rasterproof_stepping {
  int32_t along_y;
  int32_t sign;
  int32_t length;
  int32_t steps;
} rasterproof_stepping;

typedef struct rasterproof_plugin {
  uint32_t version; /* RASTERPROOF_PLUGIN_VERSION */
  uint32_t size;    /* sizeof(rasterproof_plugin) */
  const char* name;
  const char* summary;
  /* What it states: the name of a preset ("real"; the models "gl-canonical", "vulkan-canonical",
   * "d3d11-canonical"; the legal sets "gl", "vulkan", "d3d11", "webgpu"), or the text of a profile
   * file (JSON). NULL: "real". */
  const char* profile;
  uint32_t input;    /* enum rasterproof_input */
  uint32_t coverage; /* enum rasterproof_coverage */
  uint32_t takes;    /* RASTERPROOF_TAKES_... */
  /* Draws every triangle of the scene. 0: done; anything else: the scene is refused (it is then not
   * judged, and the number of refusals is reported). */
  int32_t (*draw)(void* state, const rasterproof_scene* scene, const rasterproof_target* target);
  /* All optional. The state is what open returned, or NULL. */
  void* (*open)(void);
  void (*reset)(void* state); /* restores the state of open: earlier calls must not matter */
  void (*close)(void* state);
  /* Where the input is FIXED: its bits before the point (1 to 31, the sign is one of them) and
   * after it (0 to 16), whether it is signed, and whether coordinates beyond its range are given
   * too and taken modulo 2^fixed_integer_bits. Descriptions that end before these fields can't have
   * FIXED input. */
  uint32_t fixed_integer_bits;
  uint32_t fixed_fraction_bits;
  uint32_t fixed_is_signed;
  uint32_t fixed_wraps;
  /* Optional. Draws n independent scenes, each onto its own target, with the same results as draw.
   * 0: done; anything else: the batch is refused, and its scenes then come one by one. Pointers to
   * structures, so that their sizes may grow. */
  int32_t (*draw_many)(void* state, const rasterproof_scene* const* scenes,
                       const rasterproof_target* const* targets, size_t n);
  /* For the coverages PRIMITIVE_IDS and FRAGMENTS. */
  uint32_t visible;         /* enum rasterproof_visible */
  uint32_t barycentrics_of; /* enum rasterproof_barycentrics_of */
  double barycentric_error; /* largest absolute error of a barycentric; 0: none is stated */
  double depth_error;       /* largest error of a depth, in the unit of z; 0: none is stated */
  /* Optional. Its value of the edge function of a -> b at p,
   *     E = (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x),
   * evaluated at p; and its steps + 1 values on the way from p, the first at p. Each point is x, y.
   * 0: done; anything else: refused. */
  int32_t (*edge_value)(void* state, const double* a, const double* b, const double* p,
                        double* value);
  int32_t (*edge_steps)(void* state, const double* a, const double* b, const double* p,
                        const rasterproof_stepping* stepping, double* values);
  /* Most that a value is off, in units of u = 2^-24 (FLOAT64: 2^-53) times
   * |(p.x - a.x)(b.y - a.y)| + |(p.y - a.y)(b.x - a.x)|; after n steps, (n + 1) times so
   * much of the larger of the two sizes at its ends. 0: exact; negative: nothing is said. */
  double edge_error;
  double stepping_error;
} rasterproof_plugin;

/* The one function that the library exports. The description must outlive the library's use. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const rasterproof_plugin*
rasterproof_plugin_describe(void);

#ifdef __cplusplus
}
#endif

#endif /* RASTERPROOF_KIT_RASTERPROOF_PLUGIN_H_ */
