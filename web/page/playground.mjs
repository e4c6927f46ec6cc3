/**
 * The playground: corners to move, what exact arithmetic draws, and a method beside it.
 * `playground(Engine, presets)` fills the section of page.html and returns what tests look at.
 */
import {BadScene, caseOf, linkOf, playOf, playOfLink, readCase, sceneOf} from "./scene.mjs";
import {Board} from "./board.mjs";
import {cornerOf, listCorners, typedCoordinate} from "./corners.mjs";
import {firstLook, movedTo, snapped, stepped, tiesOf, viewOf, windowPoint} from "./geometry.mjs";
import {wordsOf} from "./methods.mjs";
import {nearest, numbersTable} from "./numbers.mjs";

const EXACT = {window: "filtered-exact", clip: "hom-exact"};
const IN_CLIP_SPACE = /^(hom-|kernel-clip)/;
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
const FAST = 16;

const byId = (id) => document.getElementById(`play-${id}`);
const isClip = ({vertices}) => vertices[0]?.length === 4;

class Playground {
  #Engine;
  #engine;
  #play = null;
  #past = [];
  #future = [];
  #cursor = [0, 0];
  #view = null;
  #found = null;
  #fault = "";
  #isDue = false;
  #isBusy = false;
  #drag = null;
  #boards = [new Board("Exact picture"), new Board("Picture of the method")];

  constructor(Engine, engine, presets) {
    this.#Engine = Engine;
    this.#engine = engine;
    for (const board of this.#boards) byId("boards").append(board.figure);
    this.#listenToBoards();
    this.#offer(presets);
    this.#listenToButtons(presets);
  }

  // What there is to choose from.
  #offer(presets) {
    byId("preset").append(new Option("your own", "", true, true));
    byId("preset").firstChild.disabled = true;
    presets.forEach(({group, title}, k) => {
      let last = byId("preset").lastElementChild;
      if (last.label !== group) {
        last = document.createElement("optgroup");
        last.label = group;
        byId("preset").append(last);
      }
      last.append(new Option(title, k));
    });
    byId("method").append(...this.#engine.methods().map((name) => new Option(name)));
  }

  #listenToButtons(presets) {
    byId("preset").addEventListener("change", ({target}) => {
      this.openPreset(presets[target.value], target.value);
    });
    byId("method").addEventListener("change", ({target}) => {
      this.#change({...this.#play, subject: target.value});
    });
    byId("undo").addEventListener("click", () => this.#turn(this.#past, this.#future));
    byId("redo").addEventListener("click", () => this.#turn(this.#future, this.#past));
    byId("link").addEventListener("click", () => this.#copyLink());
    byId("save").addEventListener("click", () => this.#save());
    byId("open").addEventListener("click", () => this.open(byId("text").value));
    byId("file").addEventListener("change", async ({target}) => {
      if (target.files[0]) this.open(await target.files[0].text());
      target.value = "";
    });
    byId("all").addEventListener("keydown", (event) => {
      const isTyping = event.target.matches("input, textarea");
      if (isTyping || !(event.ctrlKey || event.metaKey)) return;
      const key = event.key.toLowerCase();
      const isRedo = key === "y" || (key === "z" && event.shiftKey);
      if (!isRedo && key !== "z") return;
      event.preventDefault();
      if (isRedo) this.#turn(this.#future, this.#past);
      else this.#turn(this.#past, this.#future);
    });
    window.addEventListener("hashchange", () => this.openLink());
  }

  #listenToBoards() {
    for (const board of this.#boards) {
      const look = (event) => {
        if (this.#drag) this.#dragTo(board.at(event));
        else this.#inspect(board.at(event).map(Math.floor));
      };
      board.svg.addEventListener("pointermove", look);
      board.svg.addEventListener("pointerdown", (event) => {
        const corner = event.target.closest("[data-vertex]");
        if (!corner) return look(event);
        event.preventDefault();
        corner.focus();
        board.svg.setPointerCapture(event.pointerId);
        this.#drag = {vertex: Number(corner.dataset.vertex), before: this.#play};
      });
      // A finger on a corner drags it; elsewhere it scrolls. Not every browser heeds touch-action
      // of what is in an SVG.
      board.svg.addEventListener("touchstart", (event) => {
        if (event.target.closest("[data-vertex]")) event.preventDefault();
      }, {passive: false});
      board.svg.addEventListener("pointerup", (event) => this.#endDrag(board.at(event)));
      board.svg.addEventListener("pointercancel", () => this.#cancelDrag());
    }
    const [first] = this.#boards;
    first.svg.setAttribute("tabindex", "0");
    first.svg.setAttribute("role", "application");
    this.#boards[1].svg.setAttribute("role", "img");
    first.svg.addEventListener("keydown", (event) => this.#press(event));
  }

  #press(event) {
    const arrow = ARROWS[event.key];
    if (!arrow || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const count = event.shiftKey ? FAST : 1;
    const by = arrow.map((way) => way * count);
    const corner = event.target.closest("[data-vertex]");
    if (!corner) {
      const [x, y] = this.#cursor;
      return this.#inspect([x + by[0], y + by[1]]);
    }
    const vertex = Number(corner.dataset.vertex);
    const point = windowPoint(this.#play.vertices[vertex]);
    const step = byId("step").value;
    this.#change(this.#withPoint(vertex, point.map((x, axis) => stepped(x, by[axis], step))));
    byId("moved").textContent = this.#cornerLabel(vertex);
  }

  #withPoint(vertex, point) {
    const vertices = [...this.#play.vertices];
    vertices[vertex] = movedTo(vertices[vertex], point, this.#play.precision);
    return {...this.#play, vertices};
  }

  #dragTo(point) {
    const step = byId("step").value;
    this.#play = this.#withPoint(this.#drag.vertex, point.map((x) => snapped(x, step)));
    this.#update();
  }

  /** A press that moved nothing leaves the corner, though it was beside it by a bit. */
  #endDrag(point) {
    const drag = this.#drag;
    if (drag && this.#play !== drag.before) this.#dragTo(point);
    this.#drag = null;
    if (!drag || this.#play === drag.before) return;
    const after = this.#play;
    this.#play = drag.before;
    this.#change(after);
  }

  #cancelDrag() {
    if (this.#drag) this.#play = this.#drag.before;
    this.#drag = null;
    this.#update();
  }

  #inspect([x, y]) {
    const {width, height} = this.#play;
    this.#cursor = [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
    this.#update();
  }

  /** A step that undo takes back. */
  #change(play) {
    this.#past.push(this.#play);
    this.#future = [];
    this.#play = play;
    this.#update();
  }

  #turn(from, to) {
    if (from.length === 0) return;
    to.push(this.#play);
    this.#play = from.pop();
    this.#keepCursorInside();
    this.#update();
  }

  #keepCursorInside() {
    const {width, height} = this.#play;
    this.#cursor = [Math.min(this.#cursor[0], width - 1), Math.min(this.#cursor[1], height - 1)];
  }

  /** Shows a scene. `about` is a text on it. */
  show(play, about = "") {
    byId("preset").value = "";
    byId("about").textContent = about;
    const methods = Array.from(byId("method").options, ({value}) => value);
    const fallback = isClip(play) ? "hom-f32" : "f32-direct";
    const subject = [play.subject, fallback].find((name) => methods.includes(name)) ?? methods[0];
    this.#complain("");
    if (this.#play) this.#past.push(this.#play);
    this.#future = [];
    this.#play = {...play, subject};
    this.#view = null;  // The picture says where to look first.
    this.#update();
  }

  openPreset(preset, value) {
    this.show(playOf(preset.case), preset.say);
    byId("preset").value = value;
  }

  /** Opens a case as a text. */
  open(text) {
    this.#try(() => {
      const play = readCase(text);
      const was = play.subject && !this.#engine.methods().includes(play.subject) ?
          ` It was found with ${play.subject}, which is no built-in method.` : "";
      this.show(play, `Opened: ${play.name}.${was}`);
    });
  }

  /** Opens the scene of the page's address; false if there is none. */
  openLink() {
    return this.#try(() => {
      const play = playOfLink(location.hash);
      if (!play) return false;
      this.show(play, `From a link: ${play.name}.`);
      byId("all").scrollIntoView();
      return true;
    });
  }

  #try(action) {
    try {
      return action();
    } catch (error) {
      if (!(error instanceof BadScene)) throw error;
      this.#complain(`${error.message}.`);
      return false;
    }
  }

  #complain(text) {
    byId("fault").textContent = text;
  }

  async #copyLink() {
    const address = location.href.replace(/#.*/, "") + linkOf(this.#play);
    history.replaceState(null, "", linkOf(this.#play));
    try {
      await navigator.clipboard.writeText(address);
      byId("moved").textContent = "The link is copied.";
    } catch {
      byId("moved").textContent = "The link is in the address bar.";
    }
  }

  #save() {
    const blob = new Blob([JSON.stringify(caseOf(this.#play), null, 1)],
        {type: "application/json"});
    const link = document.createElement("a");
    link.download = "case.json";
    link.href = URL.createObjectURL(blob);
    link.click();
    URL.revokeObjectURL(link.href);
  }

  /** One picture a frame at most. */
  #update() {
    if (this.#isDue) return;
    this.#isDue = true;
    requestAnimationFrame(async () => {
      if (this.#isBusy) return;
      this.#isBusy = true;
      try {
        while (this.#isDue) {
          this.#isDue = false;
          await this.#render();
        }
      } finally {
        this.#isBusy = false;
      }
    });
  }

  /** An answer of the engine; null, with this.#fault, if it has none. */
  async #ask(question) {
    try {
      return question(this.#engine);
    } catch (error) {
      this.#fault = error.message;
      this.#engine = await this.#Engine.create();
      return null;
    }
  }

  #sceneFor(method) {
    const play = {...this.#play};
    if (play.vertices.flat().every((x) => Object.is(Math.fround(x), x))) play.precision = "float32";
    if (IN_CLIP_SPACE.test(method) && !isClip(play)) {
      play.vertices = play.vertices.map(([x, y, z = 0]) => [x, y, z, 1]);
    }
    return sceneOf(play);
  }

  async #render() {
    const play = this.#play;
    const {subject, width, height} = play;
    const exact = await this.#ask((engine) => {
      return engine.draw(EXACT[isClip(play) ? "clip" : "window"], sceneOf(play));
    });
    if (!exact) {
      this.#complain(`The engine does not take this scene: ${this.#fault}`);
      if (this.#past.length === 0) return;
      this.#play = this.#past.pop();
      this.#isDue = true;
      return;
    }
    const ask = (at) => this.#ask((engine) => engine.draw(subject, this.#sceneFor(subject), at));
    if (!this.#view) this.#cursor = firstLook(play, exact, await ask());
    this.#view = viewOf(this.#view, play, this.#cursor);
    const centre = this.#cursor.map((n) => n + 0.5);
    const drawn = await ask(isClip(play) ? undefined : centre);
    const triangles = play.triangles.map((indices) => ({
      indices, corners: indices.map((k) => windowPoint(play.vertices[k]) ?? [NaN, NaN]),
    }));
    const ties = tiesOf(triangles, this.#view);
    const rows = [];
    for (const k of isClip(play) ? [] : nearest(triangles, centre)) {
      const {indices, corners} = triangles[k];
      const decided = await this.#ask((engine) => engine.covers({
        triangle: indices.map((index) => play.vertices[index].slice(0, 2)),
        pixel: this.#cursor, width, height,
      })) ?? {};
      rows.push({k, indices, decided, edges: drawn?.triangles?.[k]?.edges,
        isTie: tiesOf([{corners}], {...cellAt(this.#cursor)}).length > 0});
    }
    this.#found = {play, exact, drawn, ties, rows, triangles};
    this.#paint();
  }

  #paint() {
    const {play, exact, drawn, ties, rows, triangles} = this.#found;
    const lines = triangles.flatMap(({corners: [a, b, c]}) => [[a, b], [b, c], [c, a]])
        .filter((line) => line.flat().every(Number.isFinite));
    const common = {view: this.#view, width: play.width, exact: exact.counts, lines, ties,
      cursor: this.#cursor};
    const [first, second] = this.#boards;
    first.show({...common, counts: exact.counts});
    // Ties would hide the signs of what differs.
    second.show({...common, ties: [], counts: drawn?.counts ?? null});
    first.title = `Exact arithmetic${this.#partShown()}`;
    second.title = this.#methodTitle();
    second.svg.setAttribute("aria-label", second.title);
    first.svg.setAttribute("aria-label", `Exact picture of ${play.width} by ${play.height} ` +
        "pixels. Arrow keys move the pixel whose numbers are shown, Tab goes to the corners");
    this.#placeCorners();
    byId("words").textContent = wordsOf(play.subject);
    byId("said").textContent = this.#sentence();
    byId("numbers").replaceChildren(numbersTable(rows, play.subject));
    byId("clip").hidden = !isClip(play);
    byId("numbers").hidden = isClip(play);
    byId("undo").disabled = this.#past.length === 0;
    byId("redo").disabled = this.#future.length === 0;
    byId("method").value = play.subject;
    listCorners(byId("corners"), play.vertices, (...typed) => this.#type(...typed));
    byId("precision").textContent = `Numbers are ${play.precision} ones.`;
  }

  #partShown() {
    const {x, y, width, height} = this.#view;
    if (width === this.#play.width && height === this.#play.height) return "";
    return `, columns ${x} to ${x + width - 1}, rows ${y} to ${y + height - 1}`;
  }

  #methodTitle() {
    const {play, exact, drawn} = this.#found;
    if (!drawn) return `${play.subject} does not take this scene`;
    const count = (differs) => exact.counts.filter((n, k) => differs(drawn.counts[k], n)).length;
    const [missing, unexpected] = [count((a, b) => a < b), count((a, b) => a > b)];
    const bits = drawn.profile.subpixel_bits;
    const grid = bits ? `; it rounds corners to 1/${2 ** bits} pixel, so it may differ` : "";
    return missing + unexpected === 0 ? `${play.subject}: the same picture${grid}` :
      `${play.subject}: ${missing} missing, ${unexpected} unexpected${grid}`;
  }

  #sentence() {
    const {play, exact, drawn, rows, ties} = this.#found;
    const [x, y] = this.#cursor;
    const k = y * play.width + x;
    const times = (n) => n === 0 ? "not drawn" : n === 1 ? "drawn once" : `drawn ${n} times`;
    const by = rows.filter(({decided}) => decided.covers === "must").map((row) => row.k);
    const who = by.length === exact.counts[k] && by.length > 0 ?
        `, by triangle ${by.join(" and ")}` : "";
    const tie = ties.some(([a, b]) => a === x && b === y) ? " Its centre lies on an edge: a tie." :
                                                             "";
    const other = drawn?.counts[k];
    const kind = other < exact.counts[k] ? "missing" : "unexpected";
    const differs = drawn && other !== exact.counts[k] ?
        ` By ${play.subject}: ${times(other)}, ${kind}.` : "";
    return `Pixel (${x}, ${y}), centre (${x + 0.5}, ${y + 0.5}): ${times(exact.counts[k])}${who}.` +
        tie + differs;
  }

  #cornerLabel(vertex) {
    const point = windowPoint(this.#play.vertices[vertex]);
    return point ? `Corner ${vertex} at ${point.join(", ")}` : `Corner ${vertex} is nowhere`;
  }

  /** Elements stay while there are as many: focus and pointer keep theirs. */
  #placeCorners() {
    const {vertices} = this.#play;
    const size = (Math.max(this.#view.width, this.#view.height) + 2) / 100;
    const isDragged = this.#drag?.vertex;
    for (const board of this.#boards) {
      const holder = board.corners;
      while (holder.childElementCount > vertices.length) holder.lastChild.remove();
      while (holder.childElementCount < vertices.length) holder.append(cornerOf(holder, board));
      vertices.forEach((vertex, k) => {
        const corner = holder.children[k];
        const point = windowPoint(vertex);
        corner.style.display = point ? "" : "none";
        if (!point) return;
        const [x, y] = board.place(point);
        const isFar = x !== point[0] || y !== point[1];
        corner.setAttribute("transform", `translate(${x} ${y}) scale(${size})`);
        corner.setAttribute("class",
            `corner${isFar ? " far" : ""}${isDragged === k ? " dragged" : ""}`);
        if (board === this.#boards[0]) {
          corner.setAttribute("aria-label", this.#cornerLabel(k));
        }
      });
    }
  }

  #type(vertex, axis, text) {
    this.#try(() => {
      const place = `Corner ${vertex}, ${"xyzw"[axis]},`;
      const value = typedCoordinate(text, this.#play.precision, place);
      const vertices = this.#play.vertices.map((old) => [...old]);
      vertices[vertex][axis] = value;
      this.#complain("");
      this.#change({...this.#play, vertices});
    });
  }

  /** For tests: the scene, and what was found of it when nothing more is to be drawn. */
  async settled() {
    do await new Promise(requestAnimationFrame); while (this.#isDue || this.#isBusy);
    const {exact, drawn, ties, rows} = this.#found;
    return {play: this.#play, exact: exact.counts, drawn: drawn?.counts, ties,
      cursor: this.#cursor,
      rows: rows.map(({k, decided, edges}) => ({k, ...decided, drawn: edges})),
    };
  }
}

const cellAt = ([x, y]) => ({x, y, width: 1, height: 1});

/** Fills the section, or says there why not. */
export async function playground(Engine, presets) {
  let engine;
  try {
    engine = await Engine.create();
  } catch (error) {
    byId("missing").textContent =
        `The playground needs the engine, which this browser did not start: ${error.message}`;
    return null;
  }
  const made = new Playground(Engine, engine, presets);
  byId("missing").hidden = true;
  byId("all").hidden = false;
  made.openPreset(presets[0], "0");
  made.openLink();
  return made;
}
