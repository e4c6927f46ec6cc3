// Skia (CanvasKit, software), paths without antialiasing: a pixel whose centre is a corner of several
// triangles around it is covered by all of them, or by none.
//
//   npm install canvaskit-wasm@0.42.0 && node skia_vertex_on_centre.mjs
//
// Prints how often each pixel of a 12 x 3 surface is covered by the triangles of a fan, each filled
// on its own. The fan's hub is the centre of a pixel; it should be covered once.
import CanvasKitInit from 'canvaskit-wasm/bin/canvaskit.js';

const kit = await CanvasKitInit();
const surface = kit.MakeSurface(12, 3);
const canvas = surface.getCanvas();
const paint = new kit.Paint();
paint.setAntiAlias(false);

function draw(hub, rim) {
  const counts = new Array(36).fill(0);
  for (let k = 0; k < rim.length; ++k) {
    const builder = new kit.PathBuilder();
    builder.addPolygon([hub, rim[k], rim[(k + 1) % rim.length]].flat(), true);
    canvas.clear(kit.TRANSPARENT);
    canvas.drawPath(builder.detach(), paint);
    const pixels = canvas.readPixels(0, 0, surface.imageInfo());
    for (let p = 0; p < 36; ++p) counts[p] += pixels[4 * p + 3] !== 0 ? 1 : 0;
  }
  const rows = [0, 1, 2].map((y) => counts.slice(12 * y, 12 * y + 12).join(''));
  console.log(`hub (${hub.join(', ')}): ${rows.join(' ')}`);
}

draw([1.5, 1.5], [[-1, -2], [0, 7], [5, -1]]);
draw([9.5, 0.5], [[4591.265625, -7484.125], [10.5, 9.5], [8.46875, 1.5], [0.078125, -0.171875]]);
