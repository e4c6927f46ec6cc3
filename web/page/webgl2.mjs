/**
 * Draws with WebGL2: additive blending into the best format that the browser lets it blend. Of
 * several samples a pixel only the average can be read: counts are sums over a pixel.
 */
import {
  LostError, MOST_SIDE, addCounts, checkScene, clipVertices, parts, powerBelow, targetSides,
  viewportOf,
} from "./drawer.mjs";
import {CORNER_FLOATS, Shown, cornersOf, passesOf} from "./shading.mjs";

/* one: what a fragment adds, and a count of 1 is in the target. */
const FORMATS = {
  r32f: {name: "RGBA32F", ceiling: 2 ** 24, one: 1},
  half: {name: "RGBA16F", ceiling: 2048, one: 1},
  rgba8: {name: "RGBA8", ceiling: 255, one: 1 / 255},
};

const vertexShader = (position) => `#version 300 es
layout(location = 0) in vec4 vertex;
uniform highp float unit;
flat out highp vec4 passed;
void main() {
  highp vec4 p = vertex;
  ${position}
  passed = vertex;
  gl_Position = p;
}`;

const FRAGMENT_SHADER = `#version 300 es
precision highp float;
uniform vec3 add;
out vec4 color;
void main() {
  color = gl_FrontFacing || add.z == 0.0 ? vec4(add.x, 0, 0, 0) : vec4(0, add.y, 0, 0);
}`;

/* GLSL ES interpolates in perspective or not at all. With one sample all places are its centre. */
const SHADE_VERTEX_SHADER = `#version 300 es
layout(location = 0) in vec4 clip;
layout(location = 1) in vec2 numbers;
smooth out highp vec2 perspective;
flat out highp vec2 provoking;
flat out highp float number;
void main() {
  perspective = provoking = numbers;
  number = float(gl_VertexID / 3 + 1);
  gl_Position = clip;
}`;
const SHADE_FRAGMENT_SHADER = `#version 300 es
precision highp float;
precision highp int;
uniform ivec2 kinds;
smooth in highp vec2 perspective;
flat in highp vec2 provoking;
flat in highp float number;
layout(location = 0) out vec4 shown;
layout(location = 1) out vec4 slopes;
void main() {
  vec2 way[4] = vec2[4](provoking, perspective, perspective, vec2(gl_FragCoord.w));
  vec2 value = vec2(way[kinds.x % 4].x, way[kinds.y % 4].y);
  shown = vec4(number, value, gl_FragCoord.z);
  slopes = vec4(dFdx(value), dFdy(value));
}`;
const SHADED = ["COLOR_ATTACHMENT0", "COLOR_ATTACHMENT1"];

class WebGl2Drawer {
  #gl;
  #plant;
  #format;
  #cache = new Map();
  #lossReason = null;

  constructor(gl, format, info, plant) {
    this.#gl = gl;
    this.#format = format;
    this.#plant = plant;
    this.info = info;
    this.lost = new Promise((resolve) => {
      gl.canvas.addEventListener("webglcontextlost", () => {
        this.#lossReason = "the browser took the WebGL context away";
        resolve(this.#lossReason);
      }, {once: true});
    });
  }

  lose() {
    this.#gl.getExtension("WEBGL_lose_context").loseContext();
  }

  close() {
    this.#gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  #kept(key, make) {
    if (!this.#cache.has(key)) this.#cache.set(key, make());
    return this.#cache.get(key);
  }

  #shader(type, text) {
    const gl = this.#gl;
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
  }

  #linked(vertexText, fragmentText, passed) {
    const gl = this.#gl;
    const program = gl.createProgram();
    gl.attachShader(program, this.#shader(gl.VERTEX_SHADER, vertexText));
    gl.attachShader(program, this.#shader(gl.FRAGMENT_SHADER, fragmentText));
    if (passed) gl.transformFeedbackVaryings(program, [passed], gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`a shader is refused: ${gl.getProgramInfoLog(program)}`);
    }
    return program;
  }

  #program(position) {
    return this.#kept(`program ${position}`, () => {
      const gl = this.#gl;
      const program = this.#linked(vertexShader(position), FRAGMENT_SHADER, "passed");
      const [unit, add] = ["unit", "add"].map((name) => gl.getUniformLocation(program, name));
      return {program, unit, add};
    });
  }

  #framebuffer(sides, samples) {
    return this.#kept(`target ${sides} ${samples}`, () => {
      const gl = this.#gl;
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      const target = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, target);
      const format = gl[this.#format.name];
      if (samples > 1) {
        gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, ...sides);
      } else {
        gl.renderbufferStorage(gl.RENDERBUFFER, format, ...sides);
      }
      gl.framebufferRenderbuffer(
          gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, target);
      return framebuffer;
    });
  }

  #upload(target, data) {
    const gl = this.#gl;
    gl.bindBuffer(target, this.#kept(`buffer ${target}`, () => gl.createBuffer()));
    gl.bufferData(target, data, gl.STREAM_DRAW);
  }

  #bindVertices(data) {
    const gl = this.#gl;
    this.#upload(gl.ARRAY_BUFFER, data);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0);
  }

  /** Rejects what the context refused since the last call. */
  #check() {
    const gl = this.#gl;
    const error = gl.getError();
    if (this.#lossReason !== null || gl.isContextLost()) {
      throw new LostError(this.#lossReason ?? "the browser took the WebGL context away");
    }
    if (error !== gl.NO_ERROR) throw new Error(`WebGL error 0x${error.toString(16)}`);
  }

  #drawPass(pass, scene, samples, unit) {
    const gl = this.#gl;
    const {program, unit: unitPlace, add} = this.#program(pass.position);
    gl.useProgram(program);
    const {one} = this.#format;
    gl.uniform1f(unitPlace, unit);
    gl.uniform3f(add, one, one, scene.facing ?? true ? 1 : 0);
    const all = 2 ** samples - 1;
    if (pass.mask === all) {
      gl.disable(gl.SAMPLE_COVERAGE);
    } else {
      // The browser chooses which samples; those of a mask and of the rest are each other's rest.
      const isRest = (pass.mask & 1) !== 0;
      const covered = [...pass.mask.toString(2)].filter((bit) => bit === "1").length;
      gl.enable(gl.SAMPLE_COVERAGE);
      gl.sampleCoverage((isRest ? samples - covered : covered) / samples, isRest);
    }
    this.#upload(gl.ELEMENT_ARRAY_BUFFER, pass.indices);
    gl.drawElements(gl.TRIANGLES, pass.indices.length, gl.UNSIGNED_INT, 0);
  }

  #drawPart(part, scene) {
    const gl = this.#gl;
    const {width, height, samples = 1} = scene;
    const sides = targetSides(scene, this.info.viewport);
    const framebuffer = this.#framebuffer(sides, samples);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const rectangle = viewportOf(scene, this.info.viewport);
    gl.viewport(...rectangle);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, width, height);
    const {one} = this.#format;
    gl.clearColor(one * part.start[0], one * part.start[1], 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.blendEquation(this.#plant.blend === "max" ? gl.MAX : gl.FUNC_ADD);
    for (const pass of part.passes) {
      if (pass.indices.length > 0) this.#drawPass(pass, scene, samples, 2 / rectangle[2]);
    }
    if (samples > 1) {
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.#framebuffer(sides, 1));
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
      gl.blitFramebuffer(
          0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer(sides, 1));
    }
  }

  /** Front and back of each pixel in turn, as sums over its samples. */
  #read({width, height, samples = 1}) {
    const gl = this.#gl;
    const isFloat = this.#format.one === 1;
    const pixels = new (isFloat ? Float32Array : Uint8Array)(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, pixels);
    this.#check();
    return Float32Array.from({length: 2 * width * height}, (_, k) => {
      return samples * pixels[4 * (k >> 1) + (k & 1)];
    });
  }

  async draw(scene) {
    checkScene(scene, this.info);
    const gl = this.#gl;
    const samples = scene.samples ?? 1;
    this.#bindVertices(clipVertices(scene, this.info.viewport, 1, 0));
    const length = scene.width * scene.height;
    const counts = {
      front: new Uint32Array(length), back: new Uint32Array(length), resolved: samples > 1,
    };
    for (const part of parts(scene, this.info, this.#plant)) {
      this.#drawPart(part, scene);
      const values = this.#read(scene);
      this.#plant.read?.(values);
      addCounts(counts, values);
    }
    gl.disable(gl.BLEND);
    return counts;
  }

  #shadeTarget(sides) {
    return this.#kept(`shade ${sides}`, () => {
      const gl = this.#gl;
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      for (const attachment of SHADED) {
        const target = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, target);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, ...sides);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl[attachment], gl.RENDERBUFFER, target);
      }
      gl.drawBuffers(SHADED.map((attachment) => gl[attachment]));
      return framebuffer;
    });
  }

  /** Draws two channels: four floats a pixel of each of two targets. */
  #shadePass(scene, corners, kinds) {
    const gl = this.#gl;
    const {shade = (code) => code} = this.#plant;
    const program = this.#kept("shade", () => {
      return this.#linked(shade(SHADE_VERTEX_SHADER), shade(SHADE_FRAGMENT_SHADER));
    });
    gl.useProgram(program);
    gl.uniform2i(gl.getUniformLocation(program, "kinds"), ...kinds);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#shadeTarget(targetSides(scene, this.info.viewport)));
    gl.viewport(...viewportOf(scene, this.info.viewport));
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, scene.width, scene.height);
    gl.disable(gl.SAMPLE_COVERAGE);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.#upload(gl.ARRAY_BUFFER, corners);
    [[0, 4, 0], [1, 2, 16]].forEach(([place, size, offset]) => {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * CORNER_FLOATS, offset);
    });
    gl.drawArrays(gl.TRIANGLES, 0, corners.length / CORNER_FLOATS);
    gl.disableVertexAttribArray(1);
    const read = SHADED.map((attachment) => {
      const pixels = new Float32Array(4 * scene.width * scene.height);
      gl.readBuffer(gl[attachment]);
      gl.readPixels(0, 0, scene.width, scene.height, gl.RGBA, gl.FLOAT, pixels);
      return pixels;
    });
    this.#check();
    return read;
  }

  async shade(scene) {
    checkScene(scene, this.info);
    const placed = clipVertices(scene, this.info.viewport, 1, 0);
    const all = new Shown(scene);
    for (const pass of passesOf(scene)) {
      const corners = cornersOf(scene, placed, 0, pass.channels);
      const [shown, slopes] = this.#shadePass(scene, corners, pass.kinds);
      all.take(pass, (k, n) => n < 4 ? shown[4 * k + n] : slopes[4 * k + n - 4]);
    }
    return all.fragments;
  }

  async echo(vertices) {
    const gl = this.#gl;
    const {program} = this.#program("");
    gl.useProgram(program);
    this.#bindVertices(vertices);
    const buffer = gl.createBuffer();
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, vertices.byteLength, gl.STREAM_READ);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, vertices.length / 4);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    const bits = new Uint32Array(vertices.length);
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, bits);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.deleteBuffer(buffer);
    this.#check();
    return bits;
  }
}

/** The best format that can be blended, or the one that is asked for. */
function chosenFormat(gl, wanted) {
  const floats = gl.getExtension("EXT_color_buffer_float");
  const can = {
    r32f: floats && gl.getExtension("EXT_float_blend"),
    half: floats || gl.getExtension("EXT_color_buffer_half_float"),
    rgba8: true,
  };
  const name = wanted ?? ["half", "rgba8"].find((one) => can[one]);
  if (!can[name]) throw new Error(`this browser does not blend into ${FORMATS[name].name}`);
  return FORMATS[name];
}

function adapterOf(gl) {
  const extension = gl.getExtension("WEBGL_debug_renderer_info");
  return {
    vendor: gl.getParameter(extension ? extension.UNMASKED_VENDOR_WEBGL : gl.VENDOR),
    renderer: gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
    version: gl.getParameter(gl.VERSION),
    isMasked: !extension,
  };
}

/** What the browser does not say of the renderer: some name the family alone. */
function hiddenOf({isMasked, renderer}) {
  if (isMasked) return ["renderer"];
  return String(renderer).endsWith("or similar") ? ["which renderer of its family"] : [];
}

/** Whether a viewport is taken that begins left of and below the target. */
function takesCentred(gl, reach) {
  gl.viewport(-reach, -reach, 2 * reach, 2 * reach);
  const taken = gl.getParameter(gl.VIEWPORT);
  return gl.getError() === gl.NO_ERROR && taken[0] === -reach && taken[2] === 2 * reach;
}

/**
 * @param {{viewport?: "ordinary", format?: "r32f"|"half"|"rgba8",
 *     plant?: import("./drawer.mjs").Plant}} [options]
 *     In GLSL a plant's `unit` is a uniform.
 * @returns {Promise<import("./drawer.mjs").Drawer>}
 * @throws Error with the reason if there is no WebGL2 here.
 */
export async function open({viewport, format, plant = {}} = {}) {
  const canvas = globalThis.OffscreenCanvas ? new OffscreenCanvas(1, 1) :
                                              document.createElement("canvas");
  const gl = canvas.getContext("webgl2", {
    antialias: false, depth: false, stencil: false, powerPreference: "high-performance",
  });
  if (!gl) throw new Error("this browser has no WebGL2 here");
  const chosen = chosenFormat(gl, format);
  const bounds = Math.min(...gl.getParameter(gl.MAX_VIEWPORT_DIMS));
  const reach = powerBelow(bounds) / 2;
  const isCentred = viewport !== "ordinary" && takesCentred(gl, reach);
  const most = chosen.one === 1 ? gl.getInternalformatParameter(
      gl.RENDERBUFFER, gl[chosen.name], gl.SAMPLES) : [];
  const adapter = adapterOf(gl);
  const side = Math.min(gl.getParameter(gl.MAX_RENDERBUFFER_SIZE), reach, MOST_SIDE);
  return new WebGl2Drawer(gl, chosen, {
    api: "webgl2",
    adapter,
    limits: {maxViewport: bounds, maxSamples: most[0] ?? 1, format: chosen.name},
    hidden: ["sample places", ...hiddenOf(adapter)],
    samples: most.includes(4) ? [1, 4] : [1],
    subpixelBits: gl.getParameter(gl.SUBPIXEL_BITS),
    largestTarget: powerBelow(side),
    ceiling: chosen.ceiling,
    yAxis: "up",
    perSample: false,
    values: isCentred && gl.getExtension("EXT_color_buffer_float") ?
        {provoking: "last", inverse_w: true} : null,
    viewport: isCentred ? {kind: "centred", reach, error: 0} :
                          {kind: "ordinary", reach: 128, error: 2 ** -18},
  }, plant);
}
