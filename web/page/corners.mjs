/** Corners to take, and corners as numbers to type. */
import {svg} from "./board.mjs";
import {coordinate} from "./scene.mjs";

const MOST_LISTED = 24;

/** A corner to take: a large invisible disc, a small visible one, and the vertex's number. */
export function cornerOf(holder, board) {
  const vertex = holder.childElementCount;
  const isFirst = board.svg.getAttribute("role") === "application";
  const attributes = isFirst ? {tabindex: 0, role: "button", "aria-roledescription": "corner"} :
                               {"aria-hidden": "true"};
  return svg("g", {"data-vertex": vertex, class: "corner", ...attributes}, [
    svg("circle", {r: 5.5, class: "reach"}), svg("circle", {r: 1.6, class: "dot"}),
    svg("text", {x: 2.2, y: -2}, [String(vertex)]),
  ]);
}

/** Inputs for the first corners' coordinates, unless one of them is in use. */
export function listCorners(holder, vertices, onTyped) {
  if (holder.contains(document.activeElement)) return;
  holder.replaceChildren(...vertices.slice(0, MOST_LISTED).map((vertex, k) => {
    const inputs = vertex.map((x, axis) => {
      const input = document.createElement("input");
      input.value = Object.is(x, -0) ? "-0" : x;
      input.setAttribute("aria-label", `Corner ${k}, ${"xyzw"[axis]}`);
      input.addEventListener("change", () => onTyped(k, axis, input.value.trim()));
      return input;
    });
    const row = document.createElement("li");
    row.append(`${k}: `, ...inputs);
    return row;
  }));
}

/** A coordinate as it is typed: decimal, or as case files write it. */
export function typedCoordinate(text, precision, place) {
  const isDecimal = text !== "" && Number.isFinite(Number(text)) && !/x/i.test(text);
  return coordinate(isDecimal ? Number(text) : text, precision, place);
}
