/* FreeType's monochrome rasterizer: a pixel on the edge of two outlines is in neither.
 *
 *   cc freetype_mono_seam.c $(pkg-config --cflags --libs freetype2) -lm && ./a.out
 *
 * The triangles lie on either side of the edge from (27.671875, 24.609375) to (70, 75), on which
 * the centre of pixel (38, 37) lies exactly. FreeType takes centres on an outline as inside: both
 * should cover it. Prints how many do, of it and of its neighbours to the left and right.
 */
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double kCorners[4][2] = {
    {27.671875, 24.609375}, {70, 75}, {67, -11}, {36.515625, 63.03125}};
static const int kTriangles[2][3] = {{1, 0, 2}, {3, 0, 1}};

int main(void) {
  static unsigned char bits[64][8];
  static int counts[64][64];
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
    bitmap.rows = bitmap.width = 64;
    bitmap.pitch = -8;
    bitmap.buffer = &bits[0][0];
    bitmap.pixel_mode = FT_PIXEL_MODE_MONO;
    FT_Outline_Get_Bitmap(library, &outline, &bitmap);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) counts[y][x] += bits[y][x / 8] >> (7 - x % 8) & 1;
    }
  }
  printf("%d %d %d\n", counts[37][37], counts[37][38], counts[37][39]);
  FT_Done_FreeType(library);
  return 0;
}
