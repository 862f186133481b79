/** The floor plan: what the home has, and what is known of it. Truth that nobody has told is not drawn. */
import { draw, byId, keyed, seconds, wholeSeconds } from "./dom.js";
import { state, age, known, knownLast, isFormer } from "./feed.js";
import { select, selection } from "./selection.js";

const MARGIN = 0.35;
const TRAIL = 40;
/** By what is shown: those of now are not those of a time. */
const trailsOf = new WeakMap();

function is(thing, name) {
  return thing.classes.includes(name);
}

function points(outline) {
  return outline.map(([x, y]) => `${x},${-y}`).join(" ");
}

/** Dark below, bright above, by the logarithm, as eyes see. */
function tint(lux) {
  const share = Math.min(1, Math.max(0, Math.log10(1 + lux) / 3));
  return `hsl(${48 - 10 * (1 - share)} ${Math.round(35 + 55 * share)}% ${Math.round(24 + 62 * share)}%)`;
}

function isDark(lux) {
  return Math.log10(1 + lux) / 3 < 0.5;
}

function bounds(things) {
  const all = things.flatMap((thing) => thing.outline ?? (thing.pose ? [thing.pose] : []));
  if (all.length === 0) {
    return null;
  }
  const xs = all.map((point) => point[0]);
  const ys = all.map((point) => -point[1]);
  const [left, top] = [Math.min(...xs) - MARGIN, Math.min(...ys) - MARGIN];
  return [left, top, Math.max(...xs) + MARGIN - left, Math.max(...ys) + MARGIN - top];
}

/** Where it is, as far as is known: what somebody carries is where that one is. */
export function place(thing, isCarrier = false) {
  const inside = known("in", thing.name);
  const holder = inside?.value && !isCarrier ? state.thingByName.get(inside.arguments[1]) : null;
  const by = holder?.device ? place(holder, true) : null;
  if (by) {
    return { at: by.at, fact: inside, carried: true };
  }
  const position = knownLast("position", thing.name);
  if (position && position.value !== false && Array.isArray(position.arguments[1])) {
    return { at: position.arguments[1], fact: position };
  }
  if (thing.pose) {
    return { at: thing.pose, fact: null };
  }
  return null;
}

function middle(outline) {
  const sum = outline.reduce(([x, y], point) => [x + point[0], y + point[1]], [0, 0]);
  return [sum[0] / outline.length, sum[1] / outline.length];
}

/** What of a home is drawn, as it stays the same as long as the home does. */
function drawable(home) {
  const { things } = home;
  const box = bounds(things);
  return box === null ? null : {
    box,
    unit: Math.max(box[2], box[3]) / 48,
    rooms: things.filter((thing) => thing.outline && is(thing, "Room")),
    floors: floors(things),
    doors: things.filter((thing) => thing.from && thing.to),
    signed: things.filter((thing) => sign(thing)).sort((a, b) => rank(a) - rank(b)),
  };
}

/** Names of things stand once, however many names a room has. */
function floors(things) {
  const zones = things.filter((thing) => thing.outline && is(thing, "Zone"));
  return zones.length > 0 ? zones : things.filter((thing) => thing.outline && is(thing, "Room"));
}

function lightOf(zone) {
  const light = knownLast("illuminance", zone.name);
  const isNow = light !== null && !isFormer(light);
  const lux = light ? `${Math.round(light.value)} lux${light.kind === "expected" ? " expected" : ""}` : "";
  const told = isNow ? `${lux} · ${wholeSeconds(age(light))}` : light ? `was ${lux} ${wholeSeconds(age(light))} ago` : "light unknown";
  return { value: isNow ? light.value : null, told };
}

function floor(zone, light, unit) {
  const [x, y] = middle(zone.outline);
  const top = Math.max(...zone.outline.map((point) => point[1]));
  const text = (down, size, shown) => draw("text", {
    x, y: -top + down * unit, "font-size": size * unit, "text-anchor": "middle", "stroke-width": 0.3 * unit,
  }, shown);
  return lit(draw("g", {},
    draw("polygon", { class: "room", points: points(zone.outline) }, draw("title")),
    text(1.9, 1.1, zone.label),
    text(3.2, 1)), zone, light);
}

function put(element, name, value) {
  if (element.getAttribute(name) !== value) {
    element.setAttribute(name, value);
  }
}

/** The same floor in the light that is known of now: of hundreds of rooms it becomes another one all the time. */
function lit(element, zone, { value, told }) {
  const [room, name, light] = element.children;
  const ink = value === null ? "label" : isDark(value) ? "on-dark" : "on-bright";
  put(room, "fill", value === null ? "url(#unknown)" : tint(value));
  room.firstChild.textContent = `${zone.label}: ${told}`;
  put(name, "class", ink);
  put(light, "class", `${ink} light`);
  light.textContent = told;
  return element;
}

export function openness(door) {
  const open = known("open", door.name);
  const stands = open === null ? door.open : open.value;
  const kind = stands === null ? "unknown" : stands ? "open" : "shut";
  return { kind, told: `${kind}${open === null && stands !== null ? ", as the home says" : ""}` };
}

function opening(door, { kind, told }, unit) {
  return draw("line", {
    class: `door ${kind}`, x1: door.from[0], y1: -door.from[1], x2: door.to[0], y2: -door.to[1],
    "stroke-width": 0.5 * unit, "stroke-dasharray": kind === "unknown" ? `${0.4 * unit} ${0.3 * unit}` : null,
  }, draw("title", {}, `${door.label}: ${told}`));
}

const SIGNS = {
  Lamp: (unit, level) => [
    level > 0 ? draw("circle", { class: "halo", r: (0.9 + 1.3 * level) * unit, fill: "#ffd34d", "fill-opacity": 0.45 }) : null,
    draw("circle", { class: "body", r: 0.62 * unit, fill: level > 0 ? "#ffd34d" : "#8b95a1", "stroke-width": 0.14 * unit })],
  Camera: (unit) => [draw("path", {
    class: "body", d: `M${-0.7 * unit},${-0.45 * unit}h${0.9 * unit}v${0.9 * unit}h${-0.9 * unit}zM${0.2 * unit},0l${0.6 * unit},${-0.4 * unit}v${0.8 * unit}z`,
    fill: "#5b8def", "stroke-width": 0.14 * unit })],
  MobileRobot: (unit) => [draw("rect", {
    class: "body", x: -0.9 * unit, y: -0.65 * unit, width: 1.8 * unit, height: 1.3 * unit, rx: 0.35 * unit,
    fill: "#f08c2e", "stroke-width": 0.14 * unit })],
  Person: (unit) => [draw("circle", { class: "body", r: 0.85 * unit, fill: "#3f74c9", "stroke-width": 0.14 * unit }),
    draw("circle", { r: 0.35 * unit, fill: "#ffffff" })],
  Item: (unit, level, thing) => [draw("rect", {
    class: "body", x: -0.45 * unit, y: -0.45 * unit, width: 0.9 * unit, height: 0.9 * unit,
    fill: thing.colour ?? "#9a6bd1", "stroke-width": 0.14 * unit })],
  Device: (unit) => [draw("path", {
    class: "body", d: `M0,${-0.65 * unit}l${0.65 * unit},${0.65 * unit}l${-0.65 * unit},${0.65 * unit}l${-0.65 * unit},${-0.65 * unit}z`,
    fill: "#4aa3a2", "stroke-width": 0.14 * unit })],
};

function sign(thing) {
  return Object.keys(SIGNS).find((name) => is(thing, name));
}

/** All by which the sign of a thing is drawn. */
function look(thing, where, chosen) {
  const agent = state.agentByMember.get(thing.name);
  const isOld = where.fact !== null && isFormer(where.fact);
  const isLost = thing.device !== null && agent !== undefined && agent.phase !== "ready";
  const isNamed = where.fact !== null || chosen || isLost;
  return {
    x: where.at[0],
    y: -where.at[1],
    kind: sign(thing),
    level: known("level", thing.name)?.value ?? 0,
    isOld,
    isLost,
    phase: isLost ? agent.phase : null,
    carried: where.carried === true,
    chosen,
    name: !isNamed ? null
      : isLost ? `${thing.name} ${agent.phase}`
        : isOld ? `${thing.name} ${seconds(age(where.fact))} ago` : thing.name,
  };
}

function told(thing, { kind, level, isOld, phase }) {
  return [
    thing.label,
    kind === "Lamp" ? `${Math.round(level * 100)} %` : null,
    isOld ? "perhaps not there any more" : null,
    phase,
  ].filter(Boolean).join(", ");
}

/** Told to who points at it: the age goes on while nothing is drawn. */
function seen(thing, seeming) {
  const fact = place(thing)?.fact;
  return fact ? `${told(thing, seeming)}, seen ${seconds(age(fact))} ago by ${fact.source}` : told(thing, seeming);
}

function marker(thing, seeming, unit) {
  const { x, y, kind, level, isOld, isLost, carried, chosen, name } = seeming;
  const title = draw("title", {}, seen(thing, seeming));
  return draw("g", {
    class: `thing ${isLost || isOld ? "lost" : ""} ${chosen ? "chosen" : ""}`, tabindex: 0, role: "button", "aria-label": told(thing, seeming),
    "data-thing": thing.name, transform: `translate(${x} ${y})`,
    onpointerenter: () => { title.textContent = seen(thing, seeming); },
    onclick: () => select({ thing: thing.name }),
    onkeydown: (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        select({ thing: thing.name });
      }
    },
  },
  title,
  chosen ? draw("circle", { r: 1.5 * unit, fill: "none", stroke: "var(--chosen)", "stroke-width": 0.22 * unit }) : null,
  SIGNS[kind](unit, level, thing),
  isLost ? draw("path", { d: `M${-0.7 * unit},${-0.7 * unit}L${0.7 * unit},${0.7 * unit}`, stroke: "var(--bad)", "stroke-width": 0.25 * unit }) : null,
  name === null ? null : draw("text", { class: "label", y: (carried ? -1.2 : 1.9) * unit, "font-size": 0.95 * unit, "text-anchor": "middle", "stroke-width": 0.3 * unit }, name));
}

function contains(outline, [x, y]) {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length];
    if ((ay > y) !== (by > y) && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) {
      inside = !inside;
    }
  });
  return inside;
}

/** What it could see of its own room; walls end the view. */
function field(camera, rooms, unit) {
  const room = rooms.findIndex((one) => contains(one.outline, camera.pose));
  const reach = camera.pose[2] * Math.tan((camera.viewAngle / 2) * Math.PI / 180);
  return draw("circle", { class: "field", "clip-path": room < 0 ? null : `url(#room-${room})`, cx: camera.pose[0], cy: -camera.pose[1], r: reach, "stroke-width": 0.12 * unit, "stroke-dasharray": `${0.6 * unit} ${0.5 * unit}` });
}

function follow(name, where) {
  if (!trailsOf.has(state)) {
    trailsOf.set(state, new Map());
  }
  const trails = trailsOf.get(state);
  const trail = trails.get(name) ?? [];
  const last = trail[trail.length - 1];
  if (!last || last[0] !== where.at[0] || last[1] !== where.at[1]) {
    trail.push(where.at.slice(0, 2));
    trails.set(name, trail.slice(-TRAIL));
  }
  return trails.get(name) ?? trail;
}

const LAYERS = ["floors", "fields", "walls", "doors", "trails", "things"];
let layers = null;

/** What is drawn of the home alone; what is known of it lies in layers above each other. */
function lay(plan, rooms, unit) {
  const groups = LAYERS.map((name) => [name, draw("g", { class: name })]);
  plan.replaceChildren(
    draw("defs", {}, rooms.map((room, i) => draw("clipPath", { id: `room-${i}` }, draw("polygon", { points: points(room.outline) }))),
      draw("pattern", { id: "unknown", width: 0.6 * unit, height: 0.6 * unit, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
        draw("rect", { width: 0.6 * unit, height: 0.6 * unit, fill: "var(--ground)" }),
        draw("line", { y2: 0.6 * unit, stroke: "var(--line)", "stroke-width": 0.25 * unit }))),
    ...groups.map(([, group]) => group));
  return { home: state.home, ...Object.fromEntries(groups.map(([name, group]) => [name, keyed(group)])) };
}

function rank(thing) {
  return is(thing, "Item") ? 2 : is(thing, "Person") || is(thing, "MobileRobot") ? 1 : 0;
}

/** Where everything is that has a sign; and who is nowhere. */
function sorted(signed) {
  const placed = [];
  const nowhere = [];
  for (const thing of signed) {
    const where = place(thing);
    if (where) {
      placed.push([thing, where]);
    } else if (!is(thing, "Device")) {
      const inside = known("in", thing.name);
      nowhere.push(inside && inside.value ? `${thing.name} (in ${inside.arguments[1]})` : thing.name);
    } else if (thing.device) {
      nowhere.push(thing.name);
    }
  }
  return { placed, nowhere };
}

function write(text) {
  const element = byId("nowhere");
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

export function drawMap() {
  const plan = byId("plan");
  if (layers?.home !== state.home) {
    const parts = drawable(state.home);
    if (parts === null) {
      plan.replaceChildren();
      layers = null;
      write(state.home.things.length === 0
        ? "Nothing is known of the home yet."
        : "This home has no map; give its rooms an outline, and they are drawn here.");
      return;
    }
    const { box, unit, rooms } = parts;
    plan.setAttribute("viewBox", box.join(" "));
    layers = { parts, ...lay(plan, rooms, unit) };
    layers.fields(state.home.things.filter((thing) => is(thing, "Camera") && thing.pose && thing.viewAngle)
      .map((camera) => [camera.name, "", () => field(camera, rooms, unit)]));
    layers.walls(rooms.map((room) => [room.name, "", () =>
      draw("polygon", { class: "wall", points: points(room.outline), "stroke-width": 0.3 * unit })]));
  }
  const { unit, floors: zones, doors, signed } = layers.parts;
  const chosen = selection().thing;
  const { placed, nowhere } = sorted(signed);
  const drawn = (thing, seeming, made, become) => [
    thing.name, Object.values(seeming).join("\n"), () => made(thing, seeming, unit), become && ((element) => become(element, thing, seeming))];
  layers.floors(zones.map((zone) => drawn(zone, lightOf(zone), floor, lit)));
  layers.doors(doors.map((door) => drawn(door, openness(door), opening)));
  layers.trails(placed.filter(([thing]) => is(thing, "MobileRobot")).map(([thing, where]) => {
    const way = points(follow(thing.name, where));
    return [thing.name, way, () => draw("polyline", { class: "trail", points: way, "stroke-width": 0.25 * unit })];
  }));
  layers.things(placed.map(([thing, where]) => drawn(thing, look(thing, where, thing.name === chosen), marker)));
  write(nowhere.length > 0 ? `Not known where: ${nowhere.join(", ")}` : "");
}
