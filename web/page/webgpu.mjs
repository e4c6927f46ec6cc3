/** Draws with WebGPU: additive blending into half floats, read sample by sample. */
import {
  LostError, MOST_SIDE, addCounts, checkScene, clipVertices, parts, powerBelow, targetSides,
  viewportOf,
} from "./drawer.mjs";
import {CORNER_FLOATS, SAMPLE_FLOATS, Shown, cornersOf, passesOf} from "./shading.mjs";

const FORMAT = "rgba16float";
const CEILING = 2048;  // 2049 is no half float
const ECHO_SIDE = 64;

const drawShader = (position, unit, hasFacing) => `
@vertex fn place(@location(0) vertex: vec4f) -> @builtin(position) vec4f {
  var p = vertex;
  ${position && `const unit = f32(${unit});`}
  ${position}
  return p;
}
@fragment fn count(@builtin(front_facing) isFront: bool) -> @location(0) vec4f {
  return select(vec4f(0, 1, 0, 0), vec4f(1, 0, 0, 0), ${hasFacing ? "isFront" : "true"});
}`;

const readShader = (samples) => `
@group(0) @binding(0) var<storage, read_write> counts: array<vec2f>;
@group(0) @binding(1) var<uniform> size: vec2u;
@group(0) @binding(2) var image: texture_${samples > 1 ? "multisampled_" : ""}2d<f32>;
@compute @workgroup_size(8, 8) fn read(@builtin(global_invocation_id) pixel: vec3u) {
  if (any(pixel.xy >= size)) { return; }
  for (var s = 0; s < ${samples}; s++) {
    let at = (pixel.y * size.x + pixel.x) * ${samples} + u32(s);
    counts[at] = textureLoad(image, pixel.xy, ${samples > 1 ? "s" : "0"}).rg;
  }
}`;

const PLACES_OF = {1: ["center", "centroid"], 4: ["center", "centroid", "sample"]};
const SHADED = Array.from({length: SAMPLE_FLOATS}, (_, n) => `n${n}`);

/* Every number in every way. What is interpolated at samples has the shader run for each. A target
   of four floats can't have several samples; eight of one float can. */
const shadeShader = (samples) => {
  const places = PLACES_OF[samples];
  const ways = ["linear", "perspective"].flatMap((way) => places.map((place) => [way, place]));
  const at = (place) => {
    const there = places.includes(place) ? place : "center";
    return `passed.provoking, passed.linear_${there}, passed.perspective_${there}, ` +
        "vec2f(passed.place.w)";
  };
  return `
struct Passed {
  @builtin(position) place: vec4f,
  @location(0) @interpolate(flat) provoking: vec2f,
  @location(1) @interpolate(flat) number: f32,
  ${ways.map(([way, place], k) => {
    return `@location(${k + 2}) @interpolate(${way}, ${place}) ${way}_${place}: vec2f,`;
  }).join("\n  ")}
}
struct Shown { ${SHADED.map((name, n) => `@location(${n}) ${name}: f32`).join(", ")} }
@group(0) @binding(0) var<uniform> kinds: vec2u;
@vertex fn place(@location(0) clip: vec4f, @location(1) numbers: vec2f,
    @builtin(vertex_index) k: u32) -> Passed {
  return Passed(clip, numbers, f32(k / 3 + 1), ${ways.map(() => "numbers").join(", ")});
}
@fragment fn show(passed: Passed) -> Shown {
  var way = array<vec2f, 12>(${["sample", "center", "centroid"].map(at).join(", ")});
  let value = vec2f(way[kinds.x].x, way[kinds.y].y);
  let x = dpdxFine(value);
  let y = dpdyFine(value);
  return Shown(passed.number, value.x, value.y, passed.place.z, x.x, x.y, y.x, y.y);
}`;
};

const readShadedShader = (samples) => `
${SHADED.map((name, n) => {
  return `@group(0) @binding(${n + 2}) var ${name}: texture_${
    samples > 1 ? "multisampled_" : ""}2d<f32>;`;
}).join("\n")}
@group(0) @binding(0) var<storage, read_write> numbers: array<f32>;
@group(0) @binding(1) var<uniform> size: vec2u;
@compute @workgroup_size(8, 8) fn read(@builtin(global_invocation_id) pixel: vec3u) {
  if (any(pixel.xy >= size)) { return; }
  for (var s = 0; s < ${samples}; s++) {
    let at = ${SAMPLE_FLOATS} * ((pixel.y * size.x + pixel.x) * ${samples} + u32(s));
    ${SHADED.map((name, n) => {
      return `numbers[at + ${n}] = textureLoad(${name}, pixel.xy, ${samples > 1 ? "s" : "0"}).r;`;
    }).join("\n    ")}
  }
}`;

/* Each vertex is a point of its own pixel; its numbers get there as floats and as bits. */
const ECHO_SHADER = `
struct Passed {
  @builtin(position) place: vec4f,
  @location(0) @interpolate(flat) vertex: vec4f,
}
@vertex fn place(@location(0) vertex: vec4f, @builtin(vertex_index) k: u32) -> Passed {
  let pixel = vec2f(f32(k % ${ECHO_SIDE}) + 0.5, f32(k / ${ECHO_SIDE}) + 0.5);
  let ndc = pixel / ${ECHO_SIDE / 2} - 1;
  return Passed(vec4f(ndc.x, -ndc.y, 0.5, 1), vertex);
}
@fragment fn show(passed: Passed) -> @location(0) vec4u {
  return bitcast<vec4u>(passed.vertex);
}`;

class WebGpuDrawer {
  #device;
  #plant;
  #cache = new Map();
  #lossReason = null;

  constructor(device, info, plant) {
    this.#device = device;
    this.#plant = plant;
    this.info = info;
    this.lost = device.lost.then(({reason, message}) => {
      this.#lossReason = message || reason;
      return this.#lossReason;
    });
  }

  lose() {
    this.#device.destroy();
  }

  close() {
    this.#device.destroy();
  }

  #kept(key, make) {
    if (!this.#cache.has(key)) this.#cache.set(key, make());
    return this.#cache.get(key);
  }

  #buffer(bytes, usage) {
    return this.#device.createBuffer({size: Math.max(16, Math.ceil(bytes / 4) * 4), usage});
  }

  #filled(data, usage) {
    const buffer = this.#buffer(data.byteLength, usage | GPUBufferUsage.COPY_DST);
    if (data.byteLength > 0) this.#device.queue.writeBuffer(buffer, 0, data);
    return buffer;
  }

  #target(sides, samples, format = FORMAT, number = 0) {
    const key = `target ${sides} ${samples} ${format} ${number}`;
    return this.#kept(key, () => this.#device.createTexture({
      size: sides,
      sampleCount: samples,
      format,
      usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.TEXTURE_BINDING,
    }).createView());
  }

  #drawPipeline(samples, {mask, position}, hasFacing, reach) {
    const key = `draw ${samples} ${mask} ${hasFacing} ${position && reach} ${position}`;
    return this.#kept(key, () => {
      const code = drawShader(position, 1 / reach, hasFacing);
      const module = this.#device.createShaderModule({code});
      const component = {srcFactor: "one", dstFactor: "one", operation: this.#plant.blend ?? "add"};
      return this.#device.createRenderPipeline({
        layout: "auto",
        vertex: {
          module,
          buffers: [{
            arrayStride: 16,
            attributes: [{shaderLocation: 0, offset: 0, format: "float32x4"}],
          }],
        },
        fragment: {
          module,
          targets: [{format: FORMAT, blend: {color: component, alpha: component}}],
        },
        primitive: {topology: "triangle-list", frontFace: "ccw", cullMode: "none"},
        multisample: {count: samples, mask},
      });
    });
  }

  #readPipeline(code) {
    return this.#kept(code, () => this.#device.createComputePipeline({
      layout: "auto",
      compute: {module: this.#device.createShaderModule({code})},
    }));
  }

  #shadePipeline(samples) {
    return this.#kept(`shade ${samples}`, () => {
      const {shade = (code) => code} = this.#plant;
      const module = this.#device.createShaderModule({code: shade(shadeShader(samples))});
      return this.#device.createRenderPipeline({
        layout: "auto",
        vertex: {
          module,
          buffers: [{
            arrayStride: 4 * CORNER_FLOATS,
            attributes: [{shaderLocation: 0, offset: 0, format: "float32x4"},
              {shaderLocation: 1, offset: 16, format: "float32x2"}],
          }],
        },
        fragment: {module, targets: SHADED.map(() => ({format: "r32float"}))},
        primitive: {topology: "triangle-list"},
        multisample: {count: samples},
      });
    });
  }

  #bound(pipeline, resources) {
    return this.#device.createBindGroup({
      layout: pipeline.getBindGroupLayout(0),
      entries: resources.map((resource, binding) => ({binding, resource})),
    });
  }

  /** Reads `floats` numbers of each sample by a shader: they lie in the buffer that it returns. */
  #encodeRead(encoder, {width, height, samples = 1}, code, views, floats, toDestroy) {
    const bytes = 4 * floats * width * height * samples;
    const numbers = this.#buffer(bytes, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const size = this.#filled(new Uint32Array([width, height]), GPUBufferUsage.UNIFORM);
    const read = this.#readPipeline(code);
    const compute = encoder.beginComputePass();
    compute.setPipeline(read);
    compute.setBindGroup(0, this.#bound(read, [{buffer: numbers}, {buffer: size}, ...views]));
    compute.dispatchWorkgroups(Math.ceil(width / 8), Math.ceil(height / 8));
    compute.end();
    const mapped = this.#buffer(bytes, GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ);
    encoder.copyBufferToBuffer(numbers, 0, mapped, 0, bytes);
    toDestroy.push(numbers, size, mapped);
    return mapped;
  }

  /** Encodes the draw of two channels; what samples hold lies in the buffer that it returns. */
  #encodeShaded(encoder, scene, corners, kinds, toDestroy) {
    const {width, height, samples = 1} = scene;
    const sides = targetSides(scene, this.info.viewport);
    const views = SHADED.map((_, n) => this.#target(sides, samples, "r32float", n));
    const pipeline = this.#shadePipeline(samples);
    const uniform = this.#filled(Uint32Array.from(kinds), GPUBufferUsage.UNIFORM);
    const vertices = this.#filled(corners, GPUBufferUsage.VERTEX);
    toDestroy.push(uniform, vertices);
    const pass = encoder.beginRenderPass({
      colorAttachments: views.map((view) => ({view, loadOp: "clear", storeOp: "store"})),
    });
    pass.setViewport(...viewportOf(scene, this.info.viewport), 0, 1);
    pass.setScissorRect(0, 0, width, height);
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, this.#bound(pipeline, [{buffer: uniform}]));
    pass.setVertexBuffer(0, vertices);
    pass.draw(corners.length / CORNER_FLOATS);
    pass.end();
    return this.#encodeRead(
        encoder, scene, readShadedShader(samples), views, SAMPLE_FLOATS, toDestroy);
  }

  /** Encodes one part of a drawing; the counts lie in the buffer that it returns. */
  #encode(encoder, scene, part, vertices, toDestroy) {
    const {width, height, samples = 1} = scene;
    const view = this.#target(targetSides(scene, this.info.viewport), samples);
    const pass = encoder.beginRenderPass({
      colorAttachments: [{
        view, loadOp: "clear", storeOp: "store", clearValue: [...part.start, 0, 0],
      }],
    });
    const rectangle = viewportOf(scene, this.info.viewport);
    pass.setViewport(...rectangle, 0, 1);
    pass.setScissorRect(0, 0, width, height);
    pass.setVertexBuffer(0, vertices);
    for (const one of part.passes.filter(({indices}) => indices.length > 0)) {
      const indices = this.#filled(one.indices, GPUBufferUsage.INDEX);
      toDestroy.push(indices);
      const hasFacing = scene.facing ?? true;
      pass.setPipeline(this.#drawPipeline(samples, one, hasFacing, rectangle[2] / 2));
      pass.setIndexBuffer(indices, "uint32");
      pass.drawIndexed(one.indices.length);
    }
    pass.end();
    return this.#encodeRead(encoder, scene, readShader(samples), [view], 2, toDestroy);
  }

  /** Runs what `encode` encodes and reads the buffers that it returns. */
  async #run(encode) {
    if (this.#lossReason !== null) throw new LostError(this.#lossReason);
    const toDestroy = [];
    try {
      this.#device.pushErrorScope("validation");
      const encoder = this.#device.createCommandEncoder();
      const buffers = encode(encoder, toDestroy);
      this.#device.queue.submit([encoder.finish()]);
      const error = this.#device.popErrorScope();
      const read = await Promise.all(buffers.map(async (buffer) => {
        await buffer.mapAsync(GPUMapMode.READ);
        return buffer.getMappedRange();
      }));
      const found = await error;
      if (found) throw new Error(found.message);
      return read.map((range) => range.slice(0));
    } catch (error) {
      // A loss rejects what is mapped, in some browsers before it says so.
      await Promise.race([this.lost, this.#device.queue.onSubmittedWorkDone().catch(() => {})]);
      throw this.#lossReason === null ? error : new LostError(this.#lossReason);
    } finally {
      for (const buffer of toDestroy) buffer.destroy();
    }
  }

  async draw(scene) {
    checkScene(scene, this.info);
    const found = parts(scene, this.info, this.#plant);
    const placed = clipVertices(scene, this.info.viewport, -1, 0.5);
    const read = await this.#run((encoder, toDestroy) => {
      const vertices = this.#filled(placed, GPUBufferUsage.VERTEX);
      toDestroy.push(vertices);
      return found.map((part) => this.#encode(encoder, scene, part, vertices, toDestroy));
    });
    const length = scene.width * scene.height * (scene.samples ?? 1);
    const counts = {
      front: new Uint32Array(length), back: new Uint32Array(length), resolved: false,
    };
    for (const bytes of read) {
      const values = new Float32Array(bytes);
      this.#plant.read?.(values);
      addCounts(counts, values);
    }
    return counts;
  }

  async shade(scene) {
    checkScene(scene, this.info);
    const placed = clipVertices(scene, this.info.viewport, -1, 0);
    const passes = passesOf(scene);
    const read = await this.#run((encoder, toDestroy) => passes.map(({channels, kinds}) => {
      const corners = cornersOf(scene, placed, 0.5, channels);
      return this.#encodeShaded(encoder, scene, corners, kinds, toDestroy);
    }));
    const all = new Shown(scene);
    read.forEach((bytes, k) => {
      const numbers = new Float32Array(bytes);
      all.take(passes[k], (sample, n) => numbers[SAMPLE_FLOATS * sample + n]);
    });
    return all.fragments;
  }

  async echo(vertices) {
    const count = vertices.length / 4;
    if (count > ECHO_SIDE * ECHO_SIDE) throw new RangeError("too many vertices to echo");
    const module = this.#device.createShaderModule({code: ECHO_SHADER});
    const pipeline = this.#kept("echo", () => this.#device.createRenderPipeline({
      layout: "auto",
      vertex: {
        module,
        buffers: [{
          arrayStride: 16,
          attributes: [{shaderLocation: 0, offset: 0, format: "float32x4"}],
        }],
      },
      fragment: {module, targets: [{format: "rgba32uint"}]},
      primitive: {topology: "point-list"},
    }));
    const texture = this.#kept("echo target", () => this.#device.createTexture({
      size: [ECHO_SIDE, ECHO_SIDE],
      format: "rgba32uint",
      usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
    }));
    const [bytes] = await this.#run((encoder, toDestroy) => {
      const buffer = this.#filled(vertices, GPUBufferUsage.VERTEX);
      const pass = encoder.beginRenderPass({
        colorAttachments: [{view: texture.createView(), loadOp: "clear", storeOp: "store"}],
      });
      pass.setPipeline(pipeline);
      pass.setVertexBuffer(0, buffer);
      pass.draw(count);
      pass.end();
      const bytesPerRow = 16 * ECHO_SIDE;  // a multiple of 256
      const mapped = this.#buffer(
          bytesPerRow * ECHO_SIDE, GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ);
      encoder.copyTextureToBuffer({texture}, {buffer: mapped, bytesPerRow}, [ECHO_SIDE, ECHO_SIDE]);
      toDestroy.push(buffer, mapped);
      return [mapped];
    });
    return new Uint32Array(bytes, 0, vertices.length);
  }
}

/** Whether a viewport is taken that begins left of and above the target. */
async function takesCentred(device, reach) {
  device.pushErrorScope("validation");
  const texture = device.createTexture({
    size: [256, 256], format: FORMAT, usage: GPUTextureUsage.RENDER_ATTACHMENT,
  });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginRenderPass({
    colorAttachments: [{view: texture.createView(), loadOp: "clear", storeOp: "store"}],
  });
  try {
    pass.setViewport(-reach, -reach, 2 * reach, 2 * reach, 0, 1);
    pass.end();
    device.queue.submit([encoder.finish()]);
  } catch (error) {
    await device.popErrorScope();
    return false;
  }
  return await device.popErrorScope() === null;
}

/**
 * @param {{viewport?: "ordinary", plant?: import("./drawer.mjs").Plant}} [options]
 * @returns {Promise<import("./drawer.mjs").Drawer>}
 * @throws Error with the reason if there is no WebGPU here.
 */
export async function open({viewport, plant = {}} = {}) {
  if (!globalThis.navigator?.gpu) throw new Error("this browser has no WebGPU here");
  const adapter = await navigator.gpu.requestAdapter({powerPreference: "high-performance"});
  if (!adapter) throw new Error("this browser has WebGPU and no adapter for it");
  const {maxTextureDimension2D} = adapter.limits;
  const device = await adapter.requestDevice({requiredLimits: {maxTextureDimension2D}});
  const names = ["vendor", "architecture", "device", "description"];
  const told = names.filter((name) => adapter.info?.[name]);
  const reach = powerBelow(maxTextureDimension2D) / 2;
  const isCentred = viewport !== "ordinary" && await takesCentred(device, reach);
  return new WebGpuDrawer(device, {
    api: "webgpu",
    adapter: Object.fromEntries(told.map((name) => [name, adapter.info[name]])),
    limits: {maxTextureDimension2D, maxBufferSize: device.limits.maxBufferSize},
    hidden: [...names.filter((name) => !told.includes(name)), "subpixel bits", "sample places"],
    samples: [1, 4],
    subpixelBits: null,
    largestTarget: Math.min(MOST_SIDE, reach),
    ceiling: CEILING,
    yAxis: "down",
    perSample: true,
    values: isCentred ? {provoking: "first", derivatives: "fine", linear: true} : null,
    viewport: isCentred ? {kind: "centred", reach, error: 0} :
                          {kind: "ordinary", reach: 128, error: 2 ** -18},
  }, plant);
}
