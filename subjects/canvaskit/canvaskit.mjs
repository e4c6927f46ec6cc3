// Skia's software rasterizer, compiled to wasm, as a subject on a pipe: docs/subjects.md says how it
// is asked and how it answers.
//
//   node canvaskit.mjs paths       a separate path for each triangle, filled without antialiasing
//   node canvaskit.mjs vertices    the triangles of a scene in one drawVertices
//   node canvaskit.mjs nothing     draws nothing: what the pipe itself costs
import { createRequire } from 'node:module';
import process from 'node:process';
import readline from 'node:readline';

const MOST_SUMS = 255;         // triangles that one channel of 8 bits can count
const MOST_VERTICES = 0x10000; // drawVertices takes indices of 16 bits
const OPAQUE = 255;

const require = createRequire(import.meta.url);
const init = require('canvaskit-wasm/bin/canvaskit.js');
const kit = await init({ locateFile: (file) => require.resolve(`canvaskit-wasm/bin/${file}`) });

function paintOf(alpha, blend) {
  const paint = new kit.Paint();
  paint.setAntiAlias(false);
  paint.setColor([0, 0, 0, alpha / OPAQUE]);
  paint.setBlendMode(blend);
  return paint;
}
const opaque = paintOf(OPAQUE, kit.BlendMode.SrcOver);
const addOne = paintOf(1, kit.BlendMode.Plus);

// A surface that draws into memory that can be read where it is.
class Target {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.memory = kit.Malloc(Uint8Array, 4 * width * height);
    const info = {
      width,
      height,
      colorType: kit.ColorType.RGBA_8888,
      alphaType: kit.AlphaType.Premul,
      colorSpace: kit.ColorSpace.SRGB,
    };
    this.surface = kit.MakeRasterDirectSurface(info, this.memory, 4 * width);
    this.canvas = this.surface?.getCanvas();
  }
  delete() {
    this.surface?.delete();
    kit.Free(this.memory);
  }
  // Draws on a clear target and adds every pixel's alpha, divided, to the counts.
  add(draw, divisor, counts) {
    this.memory.toTypedArray().fill(0);
    draw(this.canvas);
    const bytes = this.memory.toTypedArray(); // the memory moves when it grows
    for (let k = 0; k < counts.length; ++k) counts[k] += bytes[4 * k + 3] / divisor;
  }
}

function drawPaths({ vertices, triangles }, target, counts) {
  for (const corners of triangles) {
    const builder = new kit.PathBuilder();
    builder.addPolygon(corners.flatMap((k) => vertices[k]), true);
    const path = builder.detach();
    target.add((canvas) => canvas.drawPath(path, opaque), OPAQUE, counts);
    path.delete();
    builder.delete();
  }
}

function drawVertices({ vertices, triangles }, target, counts) {
  const positions = vertices.flat();
  for (let first = 0; first < triangles.length; first += MOST_SUMS) {
    const indices = triangles.slice(first, first + MOST_SUMS).flat();
    const mesh = kit.MakeVertices(kit.VertexMode.Triangles, positions, null, null, indices);
    target.add((canvas) => canvas.drawVertices(mesh, kit.BlendMode.Dst, addOne), 1, counts);
    mesh.delete();
  }
}

const draw = { paths: drawPaths, vertices: drawVertices, nothing: () => {} }[process.argv[2]];
if (draw === undefined) {
  process.stderr.write('usage: node canvaskit.mjs paths|vertices|nothing\n');
  process.exit(2);
}

let target = null;

// Returns the answer to a request.
function answer(id, width, height, scene) {
  if (scene.vertices.length > MOST_VERTICES) return `refused ${id} more than 65536 vertices\n`;
  if (target?.width !== width || target?.height !== height) {
    target?.delete();
    target = new Target(width, height);
  }
  if (!target.surface) return `refused ${id} no surface of ${width} x ${height}\n`;
  const counts = new Uint32Array(width * height);
  draw(scene, target, counts);
  let text = `counts ${id}\n`;
  for (let row = 0; row < height; ++row) {
    text += `${counts.subarray(row * width, (row + 1) * width).join(' ')}\n`;
  }
  return text;
}

const NAMES = { inf: Infinity, '-inf': -Infinity, nan: NaN, '-nan': NaN };
const number = (word) => NAMES[word] ?? Number(word);

const lines = readline.createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const nextWords = async () => (await lines.next()).value?.split(' ');

for (let words = await nextWords(); words !== undefined; words = await nextWords()) {
  const [, id, width, height, , , vertexCount, triangleCount] = words;
  const scene = { vertices: [], triangles: [] };
  for (let k = 0; k < vertexCount; ++k) {
    const [x, y] = await nextWords();
    scene.vertices.push([number(x), number(y)]);
  }
  for (let k = 0; k < triangleCount; ++k) scene.triangles.push((await nextWords()).map(Number));
  process.stdout.write(answer(id, Number(width), Number(height), scene));
}
