/* FreeType's monochrome rasterizer: a pixel on the edge of two outlines is in neither.
 *
 *   cc freetype_mono_seam.c $(pkg-config --cflags --libs freetype2) -lm && ./a.out
 *
 * The triangles lie on either side of the edge from (7, 3.25) to (-3.5, 7), on which the centre of
 * pixel (3, 4) lies exactly. FreeType takes centres on an outline as inside: both should cover it.
 * Prints how many do, of it and of its neighbours to the left and right.
 */
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double kCorners[4][2] = {{7, 3.25}, {2.5, -8}, {-3.5, 7}, {2.5, 9.5}};
static const int kTriangles[2][3] = {{0, 1, 2}, {0, 2, 3}};

int main(void) {
  static unsigned char bits[8];
  static int counts[8][8];
  FT_Library library;
  int major, minor, patch;
  if (FT_Init_FreeType(&library) != 0) return 2;
  FT_Library_Version(library, &major, &minor, &patch);
  printf("FreeType %d.%d.%d\n", major, minor, patch);
  for (int t = 0; t < 2; ++t) {
    FT_Vector points[3];
    char tags[3] = {FT_CURVE_TAG_ON, FT_CURVE_TAG_ON, FT_CURVE_TAG_ON};
    short last = 2;
    FT_Outline outline = {1,    3,     points,
                          tags, &last, FT_OUTLINE_IGNORE_DROPOUTS | FT_OUTLINE_HIGH_PRECISION};
    FT_Bitmap bitmap = {0};
    memset(bits, 0, sizeof bits);
    for (int k = 0; k < 3; ++k) {
      points[k].x = lrint(64 * kCorners[kTriangles[t][k]][0]);
      points[k].y = lrint(64 * kCorners[kTriangles[t][k]][1]);
    }
    bitmap.rows = bitmap.width = 8;
    bitmap.pitch = -1;
    bitmap.buffer = bits;
    bitmap.pixel_mode = FT_PIXEL_MODE_MONO;
    FT_Outline_Get_Bitmap(library, &outline, &bitmap);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) counts[y][x] += bits[y] >> (7 - x) & 1;
    }
  }
  printf("%d %d %d\n", counts[4][2], counts[4][3], counts[4][4]);
  FT_Done_FreeType(library);
  return 0;
}
