/** What is chosen, in full: a goal's story, or all that is known of a thing. */
import { make, byId, table, redraw, seconds, wholeSeconds } from "./dom.js";
import { state, age, ask, onStory } from "./feed.js";
import { select, selection } from "./selection.js";
import { isOver, stateOf } from "./goals.js";
import { drawMember, memberLine } from "./member.js";
import { drawCourse, startCourse, tabs } from "./course.js";
import { acting, clockAt, isPast } from "./past.js";

let story = { goal: null, entries: [], problem: null };

function key(entry) {
  return `${entry.at_s} ${entry.kind} ${entry.text}`;
}

async function read(goal) {
  story = { goal, entries: [], problem: null };
  try {
    const document = await ask.story(goal);
    if (story.goal === goal) {
      const told = new Set(document.story.map(key));
      story.entries = [...document.story, ...story.entries.filter((entry) => !told.has(key(entry)))];
    }
  } catch (failure) {
    story.problem = failure.message;
  }
  drawDetail();
}

onStory((entry) => {
  if (entry.goal === story.goal) {
    story.entries.push(entry);
    drawDetail();
  }
});

function line(entry, from) {
  return make("li", {},
    make("time", {}, `${(entry.at_s - from).toFixed(1)} s`),
    make("span", { class: "kind" }, entry.kind),
    make("span", { class: entry.kind }, entry.text));
}

const goalOf = (id) => state.goals.find((one) => one.id === id);

/** The same wish with all that was stated with it; as much time from now as it had then. */
const stateAgain = ({ goal, priority, deadline_s: left, age_s: since, stakes }) =>
  ask.state(goal, { priority, deadline: left === null ? null : left + since, stakes: stakes ?? {} });

function goalHead(id) {
  const goal = goalOf(id);
  return [make("h2", {},
    make("code", {}, `${id} ${goal?.goal ?? ""}`), goal ? stateOf(goal) : null, isPast() ? null : tabs(), make("span", { class: "grow" }),
    goal && isOver(goal) && goal.state !== "achieved"
      ? make("button", { type: "button", ...acting(), onclick: () => stateAgain(goal).then(({ id: again }) => select({ goal: again }), (failure) => { story.problem = failure.message; drawDetail(); }) }, "State again")
      : null,
    goal && !isOver(goal)
      ? make("button", { type: "button", ...acting(), onclick: () => ask.cancel(id).catch((failure) => { story.problem = failure.message; drawDetail(); }) }, "Cancel goal")
      : null),
  story.problem ? make("p", { class: "problem", role: "alert" }, story.problem) : null];
}

function goalDetail(id) {
  const from = story.entries[0]?.at_s ?? 0;
  const until = isPast() ? clockAt(selection().at) : Infinity;
  return [...goalHead(id),
    make("ol", { class: "story" }, story.entries.filter((entry) => entry.at_s <= until).map((entry) => line(entry, from)))];
}

function value(fact) {
  if (typeof fact.value === "number") {
    return String(Math.round(fact.value * 1000) / 1000);
  }
  return fact.value === true ? "true" : fact.value === false ? "not so" : "unknown";
}

const formula = (fact) => `(${[fact.word, ...fact.arguments.map((part) => (Array.isArray(part) ? part.join(" ") : part))].join(" ")})`;

/** The columns of a list of facts. */
export const FACTS = [
  { name: "Fact", text: formula, cell: (fact) => make("code", {}, formula(fact)) },
  { name: "Value", className: "number", text: value },
  { name: "From", text: (fact) => `${fact.source}, ${fact.kind}` },
  { name: "Age", className: "number", text: (fact) => wholeSeconds(age(fact)), value: age },
];

function thingDetail(name) {
  const thing = state.thingByName.get(name);
  if (!thing) {
    return [make("p", { class: "empty" }, `There is no ${name} in this home.`), null];
  }
  const agent = state.agentByMember.get(name);
  const known = [...state.facts.values()].filter((fact) => fact.arguments.includes(name));
  return [[
    make("h2", {}, thing.label ?? name, make("code", { class: "quiet" }, name),
      make("span", { class: "quiet" }, thing.classes.filter((one) => one !== "Thing").join(", "))),
    agent ? make("p", {}, `On the bus: ${agent.phase}${agent.state ? `, ${agent.state}` : ""}, for ${seconds(age(agent))}.`
      + (agent.why ? ` It is refused: ${agent.why}` : "")) : null,
    thing.device && !isPast() ? memberLine() : null,
  ], known.length > 0 ? table(FACTS, known) : make("p", { class: "empty" }, "Nothing is known of it yet.")];
}

/** The forms of a device stand between what it is at and what is known of it, and stay while that changes. */
function drawThing(detail, name) {
  const device = state.thingByName.get(name)?.device && !isPast();
  const shows = `thing ${name} ${Boolean(device)}`;
  if (detail.dataset.shows !== shows) {
    detail.dataset.shows = shows;
    detail.replaceChildren(make("div"), make("div", { class: "features" }), make("div"));
  }
  const [head, forms, facts] = detail.children;
  if (device) {
    drawMember(forms, name);
  }
  const [about, known] = thingDetail(name);
  redraw(head, about);
  redraw(facts, known);
}

let past = { fact: null, claims: null, problem: null };

async function readPast(fact) {
  past = { fact, claims: null, problem: null };
  try {
    const { claims } = await ask.history(fact);
    if (past.fact === fact) {
      past.claims = claims.reverse();
    }
  } catch (failure) {
    past.problem = failure.message;
  }
  drawDetail();
}

const CLAIMS = [
  { name: "Said", text: (claim) => `${claim.value === false ? "not " : ""}${formula(claim)}`, cell: (claim) => make("code", {}, `${claim.value === false ? "not " : ""}${formula(claim)}`) },
  { name: "Value", className: "number", text: value },
  { name: "By", text: (claim) => `${claim.source}, ${claim.kind}` },
  { name: "Sure", className: "number", text: (claim) => `${Math.round(claim.confidence * 100)} %` },
  { name: "When", className: "number", text: (claim) => `${seconds(claim.age_s)} before` },
  { name: "Counts", text: (claim) => (claim.counts ? "✓ now" : "–") },
];

/** Who said what of it, the latest first. */
function factDetail(fact) {
  return [
    make("h2", {}, make("code", {}, fact), make("span", { class: "quiet" }, "who said what of it until now, the latest first"),
      make("span", { class: "grow" }), make("button", { type: "button", onclick: () => readPast(fact) }, "Ask again")),
    past.problem ? make("p", { class: "problem", role: "alert" }, past.problem) : null,
    past.claims === null ? make("p", { class: "empty" }, past.problem ? "" : "…")
      : past.claims.length === 0 ? make("p", { class: "empty" }, "Nobody has said anything of it: it follows from other facts, or the home says it.")
        : table(CLAIMS, past.claims),
  ];
}

export function drawDetail() {
  const { goal, thing, fact } = selection();
  const detail = byId("detail");
  if (goal && story.goal !== goal) {
    read(goal);
  }
  if (fact && past.fact !== fact) {
    readPast(fact);
  }
  if (drawCourse()) {
    delete detail.dataset.shows;
    return;
  }
  if (thing && !goal) {
    drawThing(detail, thing);
    return;
  }
  delete detail.dataset.shows;
  const wasAtEnd = detail.scrollTop + detail.clientHeight >= detail.scrollHeight - 20;
  const top = detail.scrollTop;
  redraw(detail, goal ? goalDetail(goal) : fact ? factDetail(fact)
    : make("p", { class: "empty" }, "Choose a goal for its story, something on the map for what is known of it, or a fact for who said it."));
  detail.scrollTop = goal && wasAtEnd ? detail.scrollHeight : top;
}

startCourse(goalHead, (id) => { const goal = goalOf(id); return goal !== undefined && isOver(goal); });
