/** Simulated truth beside what is known: for who develops, and wants to see beliefs and truth differ. */
import { byId, draw, redraw, make } from "./dom.js";
import { state, ask, known } from "./feed.js";
import { select, selection } from "./selection.js";
import { openness, place } from "./map.js";

const AGAIN_MILLIS = 1000;
/** Nearer than that a thing is where it is believed to be; metres. */
const NEAR = 0.25;
const SAME_LEVEL = 0.02;
const NOT_SIMULATED = "This process simulates nothing: what is true, nobody knows.";
const PAST = "Truth has no past; go back to now.";

/** As it was told last; null: not yet, or not any more. */
let told = null;
let problem = "";
let isAsking = false;

/** Why there is no truth to be shown; null when there is. */
function objection() {
  if (state.platform !== null && !state.platform.simulated) {
    return NOT_SIMULATED;
  }
  return selection().at === null ? null : PAST;
}

function isOn() {
  return selection().truth === "on" && objection() === null;
}

async function askAgain() {
  if (isAsking) {
    return;
  }
  isAsking = true;
  try {
    told = (await ask.truth()).things;
    problem = "";
  } catch (failure) {
    told = null;
    problem = failure.message;
  }
  setTimeout(() => { isAsking = false; }, AGAIN_MILLIS);
}

const percent = (level) => `${Math.round(level * 100)} %`;

/** Where something truly is, where it is believed to be, and how far that is apart; null where it is held, and moves with its holder. */
function apart(truth) {
  const thing = state.thingByName.get(truth.name);
  const believed = thing ? place(thing) : null;
  const distance = believed === null ? null : Math.hypot(believed.at[0] - truth.at[0], believed.at[1] - truth.at[1]);
  return { believed, distance };
}

/** The sentence on what is otherwise than it is believed; null when it is not. */
function difference(truth) {
  if (truth.at !== null) {
    const { believed, distance } = apart(truth);
    const where = truth.holder ? `held by ${truth.holder}` : `at ${truth.at.map((number) => number.toFixed(1)).join(" ")}`;
    return believed === null ? `${truth.name} is ${where}, and nobody knows where`
      : distance > NEAR ? `${truth.name} is ${where}, ${distance.toFixed(1)} m from where it was known to be last` : null;
  }
  if (truth.level !== null) {
    const fact = known("level", truth.name);
    const level = typeof fact?.value === "number" ? fact.value : null;
    return level === null ? `${truth.name} shines at ${percent(truth.level)}, which nobody has told`
      : Math.abs(level - truth.level) > SAME_LEVEL ? `${truth.name} shines at ${percent(truth.level)}, and is believed to at ${percent(level)}` : null;
  }
  const door = state.thingByName.get(truth.name);
  const kind = truth.open ? "open" : "shut";
  return door && truth.open !== null && openness(door).kind !== kind ? `${truth.name} is ${kind}, and is believed to be ${openness(door).kind}` : null;
}

function label(x, y, unit, text) {
  return draw("text", { class: "label true-name", x, y, "font-size": 0.9 * unit, "text-anchor": "middle", "stroke-width": 0.3 * unit }, text);
}

/** A dashed ring where it truly is, and a line from where it is believed to be. */
function spot(truth, unit) {
  const [x, y] = [truth.at[0], -truth.at[1]];
  const { believed, distance } = apart(truth);
  const isOff = believed === null || distance > NEAR;
  return draw("g", { "data-true": truth.name },
    draw("title", {}, difference(truth) ?? `${truth.name} is where it is believed to be`),
    isOff && believed !== null ? draw("line", { class: "true-way", x1: believed.at[0], y1: -believed.at[1], x2: x, y2: y, "stroke-width": 0.14 * unit, "stroke-dasharray": `${0.3 * unit} ${0.3 * unit}` }) : null,
    draw("circle", { class: "true-ring", cx: x, cy: y, r: 1.15 * unit, "stroke-width": 0.18 * unit, "stroke-dasharray": `${0.45 * unit} ${0.3 * unit}` }),
    isOff ? draw("path", { class: "true-ring", d: `M${x - 0.4 * unit},${y}h${0.8 * unit}M${x},${y - 0.4 * unit}v${0.8 * unit}`, "stroke-width": 0.18 * unit }) : null,
    isOff ? label(x, y - 1.5 * unit, unit, `truly ${truth.name}`) : null);
}

function lamp(truth, unit) {
  const thing = state.thingByName.get(truth.name);
  if (!thing?.pose || difference(truth) === null) {
    return null;
  }
  return draw("g", { "data-true": truth.name }, draw("circle", { class: "true-ring", cx: thing.pose[0], cy: -thing.pose[1], r: 0.95 * unit, "stroke-width": 0.18 * unit, "stroke-dasharray": `${0.45 * unit} ${0.3 * unit}` }),
    label(thing.pose[0], -thing.pose[1] - 1.3 * unit, unit, `truly ${percent(truth.level)}`));
}

function door(truth, unit) {
  const thing = state.thingByName.get(truth.name);
  if (!thing?.from || !thing.to || difference(truth) === null) {
    return null;
  }
  const [x, y] = [(thing.from[0] + thing.to[0]) / 2, -(thing.from[1] + thing.to[1]) / 2];
  return draw("g", { "data-true": truth.name },
    draw("line", { class: "true-way", x1: thing.from[0], y1: -thing.from[1], x2: thing.to[0], y2: -thing.to[1], "stroke-width": 0.3 * unit, "stroke-dasharray": truth.open ? `${0.3 * unit} ${0.5 * unit}` : null }),
    label(x, y - 0.6 * unit, unit, `truly ${truth.open ? "open" : "shut"}`));
}

function drawn(truth, unit) {
  return truth.at !== null ? spot(truth, unit) : truth.level !== null ? lamp(truth, unit) : door(truth, unit);
}

/** What is drawn of the home makes the plan anew: this lies above it, as long as it is wanted. */
function drawPlan(things) {
  const plan = byId("plan");
  const box = plan.viewBox.baseVal;
  let group = plan.querySelector("g.truth");
  if (things.length === 0 || box.width === 0) {
    group?.remove();
    return;
  }
  if (group === null) {
    group = draw("g", { class: "truth" });
    plan.append(group);
  }
  const unit = Math.max(box.width, box.height) / 48;
  redraw(group, things.map((truth) => drawn(truth, unit)));
}

export function drawTruth() {
  const why = objection();
  const box = byId("truth-on");
  box.disabled = why !== null;
  box.checked = isOn();
  byId("truth-why").textContent = why ?? "";
  if (isOn() && !document.hidden) {
    askAgain();
  }
  const things = isOn() ? told ?? [] : [];
  const bar = byId("truth-told");
  bar.hidden = !isOn();
  byId("map").classList.toggle("true", isOn());
  if (isOn()) {
    const differences = things.map(difference).filter(Boolean);
    redraw(bar, make("strong", {}, "Simulated truth is drawn (dashed), which the platform does not know. "),
      problem !== "" ? make("span", { class: "problem" }, problem)
        : told === null ? "" : differences.length === 0 ? "All is as it is believed." : `${differences.join("; ")}.`);
  }
  drawPlan(things);
}

export function startTruth() {
  byId("truth-on").addEventListener("change", ({ target }) => {
    told = null;
    select({ truth: target.checked ? "on" : null });
  });
}
