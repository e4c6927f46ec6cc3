// Skia (CanvasKit, software): two triangles of one drawVertices on either side of an edge both cover
// a pixel, or neither does, if one of them reaches 16384 pixels and the other does not.
//
//   npm install canvaskit-wasm@0.42.0 && node skia_far_seam.mjs
//
// Prints how often each pixel of a 3 x 3 surface is covered, for a far corner at 16383 and at 16384.
// The centre of the pixel in question lies on the common edge: 1 is right.
import CanvasKitInit from 'canvaskit-wasm/bin/canvaskit.js';

const kit = await CanvasKitInit();
const surface = kit.MakeSurface(3, 3);
const canvas = surface.getCanvas();
const paint = new kit.Paint();
paint.setAntiAlias(false);
paint.setColor([0, 0, 0, 1 / 255]); // what is drawn twice has an alpha of 2
paint.setBlendMode(kit.BlendMode.Plus);

function draw(title, corners) {
  canvas.clear(kit.TRANSPARENT);
  const mesh = kit.MakeVertices(kit.VertexMode.Triangles, corners.flat(2));
  canvas.drawVertices(mesh, kit.BlendMode.Dst, paint);
  const pixels = canvas.readPixels(0, 0, surface.imageInfo());
  const rows = [0, 1, 2].map((y) => [0, 1, 2].map((x) => pixels[12 * y + 4 * x + 3]).join(''));
  console.log(`${title}: ${rows.join(' ')}`);
}

for (const far of [16383, 16384]) {
  const edge = [[-6, 2], [4, 0]];
  draw(`far corner (-2, -${far})`, [[...edge, [-2, -far]], [...edge, [3, 16]]]);
}
for (const far of [16383, 16384]) {
  const edge = [[6, 2], [-16, -4]];
  draw(`far corner (-${far}, -16)`, [[...edge, [-far, -16]], [...edge, [-4, -64]]]);
}
