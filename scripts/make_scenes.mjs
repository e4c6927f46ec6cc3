// Makes scenes/map.json, map-earcut.json and glyphs.json from public data, and checks them in exact integers.
//   npm ci && node scripts/make_scenes.mjs FONT.ttf
// Run once by hand; the results are committed. scenes/README.md has provenance and licences.
import cdt2d from 'cdt2d';
import earcut, {flatten} from 'earcut';
import fs from 'node:fs';
import opentype from 'opentype.js';
import {feature, merge} from 'topojson-client';

const font_path = process.argv[2];
if (!font_path) {
  console.error('usage: node scripts/make_scenes.mjs FONT.ttf');
  process.exit(2);
}

// Twice the signed area as an integer: coordinates are multiples of 2^-40.
const fixed = x => BigInt(x * 2 ** 40);
const cross = (a, b, c) =>
    (fixed(b[0]) - fixed(a[0])) * (fixed(c[1]) - fixed(a[1])) -
    (fixed(b[1]) - fixed(a[1])) * (fixed(c[0]) - fixed(a[0]));
const ring_area = ring => ring.reduce((sum, p, k) => {
  const q = ring[(k + 1) % ring.length];
  return sum + fixed(p[0]) * fixed(q[1]) - fixed(q[0]) * fixed(p[1]);
}, 0n);
const magnitude = n => n < 0n ? -n : n;

class Scene {
  constructor(name, width, height) {
    Object.assign(this, {name, width, height, vertices: [], triangles: [], ids: new Map()});
  }
  id(p) {
    const key = p.join(' ');
    if (!this.ids.has(key)) this.ids.set(key, this.vertices.push(p) - 1);
    return this.ids.get(key);
  }
  // Constrained Delaunay triangulation of the polygon: every ring vertex is kept, no vertex is added.
  add(rings, what) {
    const points = [];
    const edges = new Map();  // an edge walked twice is a spike and bounds nothing
    const ids = new Map();
    const id = p => {
      if (!ids.has(`${p}`)) ids.set(`${p}`, points.push(p) - 1);
      return ids.get(`${p}`);
    };
    for (const ring of rings) {
      ring.forEach((p, k) => {
        const edge = [id(p), id(ring[(k + 1) % ring.length])].sort((a, b) => a - b);
        if (edge[0] !== edge[1] && !edges.delete(`${edge}`)) edges.set(`${edge}`, edge);
      });
    }
    let area = 0n;
    const found = [];
    for (const t of cdt2d(points, [...edges.values()], {exterior: false})) {
      const twice = cross(...t.map(k => points[k]));
      if (twice === 0n) throw new Error(`${what}: a triangle of zero area`);
      area += magnitude(twice);
      const [a, b, c] = t.map(k => points[k]);
      found.push(twice > 0n ? [a, b, c] : [a, c, b]);
    }
    const [outer, ...holes] = rings.map(ring => magnitude(ring_area(ring))).sort((a, b) => a > b ? -1 : 1);
    const expected = holes.reduce((sum, hole) => sum - hole, outer);
    if (area !== expected || area === 0n) {
      console.log(`${what}: left out a polygon that crosses itself or is empty`);
      return;
    }
    this.triangles.push(...found.map(t => t.map(p => this.id(p))));
  }
  write() {
    const edges = new Set();
    for (const t of this.triangles) {
      for (let k = 0; k < 3; ++k) {
        const key = `${t[k]} ${t[(k + 1) % 3]}`;
        if (edges.has(key)) throw new Error(`${this.name}: directed edge ${key} twice`);
        edges.add(key);
      }
    }
    const inner = [...edges].filter(e => edges.has(e.split(' ').reverse().join(' '))).length / 2;
    const rows = list => list.map(item => JSON.stringify(item)).join(',\n');
    fs.writeFileSync(`scenes/${this.name}.json`, `{"rasterproof_scene": 1, "name": "${this.name}",
"width": ${this.width}, "height": ${this.height}, "precision": "float32",
"vertices": [
${rows(this.vertices)}],
"triangles": [
${rows(this.triangles)}]}
`);
    console.log(`${this.name}: ${this.triangles.length} triangles, ${this.vertices.length} vertices, ` +
                `${inner} edges shared by two triangles, ${edges.size - 2 * inner} boundary edges; areas exact`);
  }
}

// The topology is stitched across the antimeridian, where x jumps by a whole turn. Going on instead of jumping
// leaves the target to the right, which is what a map's edge is for. A ring around a pole does not close: nothing.
const kTurn = 99999;
function unwrap(ring) {
  let turns = 0;
  const open = ring.slice(0, -1).map(([x, y], k) => {
    const dx = k === 0 ? 0 : x - ring[k - 1][0];
    turns += dx > kTurn / 2 ? -1 : dx < -kTurn / 2 ? 1 : 0;
    return [x + turns * kTurn, y];
  });
  const last = ring.at(-1)[0] - ring.at(-2)[0];
  return turns + (last > kTurn / 2 ? -1 : last < -kTurn / 2 ? 1 : 0) === 0 ? open : undefined;
}

// Natural Earth at 1:110 million, on the topology's integer grid.
function read_topology() {
  const topology = JSON.parse(fs.readFileSync('node_modules/world-atlas/countries-110m.json'));
  delete topology.transform;  // leaves the delta-encoded integers
  for (const arc of topology.arcs) {
    let [x, y] = [0, 0];
    for (const p of arc) [p[0], p[1]] = [x += p[0], y += p[1]];
  }
  return topology;
}

// The grid is scaled by 5/512 and 5/1024 pixels: exact in float32, so borders shared on the grid stay shared, and
// what was collinear stays so; off the 1/256 grid.
const pixel = ([x, y]) => [x * 5 / 512, (99999 - y) * 5 / 1024];

function make_map() {
  const topology = read_topology();
  const scene = new Scene('map', 977, 489);
  for (const country of feature(topology, topology.objects.countries).features) {
    const {type, coordinates} = country.geometry;
    for (const polygon of type === 'Polygon' ? [coordinates] : coordinates) {
      const rings = polygon.map(unwrap);  // GeoJSON repeats a ring's first point at its end
      if (rings.every(Boolean)) {
        scene.add(rings.map(ring => ring.map(pixel)), country.properties.name);
      } else {
        console.log(`${country.properties.name}: left out a ring around the pole`);
      }
    }
  }
  scene.write();
}

// Each polygon by itself, as map renderers do it: vertices of equal value have indices of their own in each.
class EarcutScene extends Scene {
  add(rings, what) {
    const {vertices, holes} = flatten(rings);
    const points = rings.flat();
    const ring_of = rings.flatMap((ring, k) => ring.map(() => k));
    const corners = earcut(vertices, holes);
    let area = 0n;
    for (let k = 0; k < corners.length; k += 3) {
      const twice = cross(...corners.slice(k, k + 3).map(i => points[i]));
      if (twice === 0n) this.flat = (this.flat ?? 0) + 1;
      area += magnitude(twice);
      if (twice < 0n) [corners[k + 1], corners[k + 2]] = [corners[k + 2], corners[k + 1]];
    }
    const [outer, ...inner] = rings.map(ring => magnitude(ring_area(ring)));
    if (area !== inner.reduce((sum, hole) => sum - hole, outer)) throw new Error(`${what}: wrong area`);
    const ids = this.cut(corners, ring_of).map(id => id + this.vertices.length);
    for (let k = 0; k < ids.length; ++k) this.vertices[ids[k]] = points[corners[k]];
    for (let k = 0; k < ids.length; k += 3) this.triangles.push(ids.slice(k, k + 3));
  }
  // Numbers of the corners' vertices: earcut joins holes to the outline by bridges, whose ends are passed twice.
  // It gives both passes one index. Here the sides of a bridge have vertices of their own.
  cut(corners, ring_of) {
    const next = k => k % 3 === 2 ? k - 2 : k + 1;
    const starts = new Map(corners.map((a, k) => [`${a} ${corners[next(k)]}`, k]));
    const inner = corners.map((a, k) => [k, starts.get(`${corners[next(k)]} ${a}`)]).filter(([k, o]) => o > k);
    const ring = ring_of.map((_, k) => k).slice(0, Math.max(...ring_of) + 1);
    const corner = corners.map((_, k) => k);
    const root = (of, k) => of[k] === k ? k : of[k] = root(of, of[k]);
    for (const [k, other] of inner) {
      const ends = [k, next(k)].map(c => root(ring, ring_of[corners[c]]));
      ring[ends[0]] = ends[1];
      if (ends[0] !== ends[1]) continue;  // a bridge
      corner[root(corner, k)] = root(corner, next(other));
      corner[root(corner, next(k))] = root(corner, other);
    }
    const ids = new Map();
    return corner.map((_, k) => {
      const of = root(corner, k);
      if (!ids.has(of)) ids.set(of, ids.size);
      return ids.get(of);
    });
  }
  write() {
    const values = new Map();
    for (const p of this.vertices) values.set(`${p}`, p);
    const tees = this.triangles.reduce((sum, t) => sum + t.reduce((of, a, k) => {
      const [p, q] = [this.vertices[a], this.vertices[t[(k + 1) % 3]]];
      const between = (v, n) => (p[n] - v[n]) * (v[n] - q[n]) >= 0;
      return of + [...values.values()].filter(v => between(v, 0) && between(v, 1) && `${v}` !== `${p}` &&
                                                   `${v}` !== `${q}` && cross(p, q, v) === 0n).length;
    }, 0), 0);
    console.log(`${this.name}: ${values.size} places of vertices, ${tees} inside an edge, ${this.flat ?? 0} flat`);
    super.write();
  }
}

// What of the map lies wholly in a band south of it, and the sea around: its frame with the land as holes. Every
// side of more than a pixel has its middle as a vertex, which is collinear.
function make_earcut_map() {
  const topology = read_topology();
  const [top, bottom] = [50000, 11000];
  const is_long = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]) > 200;
  const middle = (p, q) => is_long(p, q) ? [[0, 1].map(k => (p[k] + q[k]) / 2)] : [];
  topology.arcs = topology.arcs.map(arc => arc.flatMap((p, k) => k === 0 ? [p] : [...middle(arc[k - 1], p), p]));
  const polygons = topology.objects.countries.geometries.flatMap(({type, arcs, properties}) =>
    (type === 'Polygon' ? [arcs] : arcs).map(part => ({type: 'Polygon', arcs: part, properties})));
  const of = polygon => feature(topology, polygon).geometry.coordinates;
  const land = polygons.filter(polygon => {
    const rings = of(polygon).map(unwrap);
    return rings.every(Boolean) && rings[0].every(([x, y]) => x > 0 && x < 99999 && y > bottom && y < top);
  });
  const place = ring => ring.map(p => pixel([p[0], p[1] + 99999 - top]));
  const [width, height] = [977, Math.ceil((top - bottom) * 5 / 1024)];
  const scene = new EarcutScene('map-earcut', width, height);
  for (const polygon of land) scene.add(of(polygon).map(unwrap).map(place), polygon.properties.name);
  const merged = merge(topology, land).coordinates.map(rings => rings.map(ring => place(unwrap(ring))));
  scene.add([[[0, 0], [width, 0], [width, height], [0, height]], ...merged.map(([outer]) => outer)], 'the sea');
  for (const [, ...lakes] of merged) lakes.forEach(lake => scene.add([lake], 'a lake'));
  scene.write();
}

// A line of text, curves flattened, every coordinate rounded once to float32.
function make_glyphs() {
  const bytes = fs.readFileSync(font_path);
  const font = opentype.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  const scene = new Scene('glyphs', 640, 48);
  const segments = 6;
  const lerp = (a, b, t) => [0, 1].map(k => a[k] + (b[k] - a[k]) * t);
  let x = 4.3;
  for (const letter of 'Sphinx of black quartz, judge my vow & 0123456789') {
    const glyph = font.charToGlyph(letter);
    const rings = [];
    let at;
    for (const c of glyph.getPath(x, 33.7, 24.6).commands) {
      const to = [c.x, c.y];
      if (c.type === 'M') rings.push([to]);
      if (c.type === 'L') rings.at(-1).push(to);
      for (let k = 1; c.type === 'Q' && k <= segments; ++k) {
        const t = k / segments;
        rings.at(-1).push(lerp(lerp(at, [c.x1, c.y1], t), lerp([c.x1, c.y1], to, t), t));
      }
      if (c.type !== 'Z') at = to;
    }
    const rounded = rings.map(ring => ring.map(p => p.map(Math.fround)));
    for (const part of parts(rounded)) scene.add(part, letter);
    x += glyph.advanceWidth * 24.6 / font.unitsPerEm;
  }
  scene.write();
}

// Outer rings turn one way and holes the other; a hole belongs to the outer ring whose box holds its first point.
function parts(rings) {
  const turn = ring => ring_area(ring) > 0n;
  const largest = rings.reduce((a, b) => magnitude(ring_area(a)) > magnitude(ring_area(b)) ? a : b, rings[0] ?? []);
  const outer = rings.filter(ring => turn(ring) === turn(largest)).map(ring => [ring]);
  for (const hole of rings.filter(ring => turn(ring) !== turn(largest))) {
    const holds = ([ring]) => [0, 1].every(k => Math.min(...ring.map(p => p[k])) <= hole[0][k] &&
                                                hole[0][k] <= Math.max(...ring.map(p => p[k])));
    outer.find(holds).push(hole);
  }
  return outer;
}

make_map();
make_earcut_map();
make_glyphs();
