// Qt 5, QPainter without antialiasing: neighbours with a far corner leave a gap, or overlap.
//
//   c++ -fPIC qt5_far_seam.cc $(pkg-config --cflags --libs Qt5Gui) && ./a.out
//
// Prints how often each pixel of a 3 x 3 image is covered by two triangles with a common edge that
// lie on either side of it and, together, cover the whole image: 1 is right.
#include <QImage>
#include <QPainter>
#include <QPointF>
#include <cstdio>

static void Draw(const char* title, const QPointF (&triangles)[2][3]) {
  int counts[3][3] = {};
  for (const auto& triangle : triangles) {
    QImage image(3, 3, QImage::Format_ARGB32_Premultiplied);
    image.fill(0);
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawConvexPolygon(triangle, 3);
    painter.end();
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) counts[y][x] += image.pixel(x, y) != 0;
    }
  }
  std::printf("%s:", title);
  for (const auto& row : counts) std::printf(" %d%d%d", row[0], row[1], row[2]);
  std::printf("\n");
}

int main() {
  std::printf("Qt %s\n", qVersion());
  const QPointF far(-31872, -8448);
  Draw("gap", {{{896, 0}, {16.625, 5.5}, far}, {{16.625, 5.5}, {0, 4}, far}});
  const QPointF top(-2768, -6240);
  const QPointF hub(4.28125, 7.75);
  Draw("overlap", {{top, hub, {0, 26624}}, {hub, top, {4, 0}}});
  return 0;
}
