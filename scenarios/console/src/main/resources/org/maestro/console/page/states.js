/** States: what is well and what is not, each as it follows from what it depends on, and why. */
import { make, byId, redraw, seconds } from "./dom.js";
import { state, ask } from "./feed.js";
import { select, selection } from "./selection.js";

const SIGNS = {
  well: ["●", "good"], off: ["–", "quiet"], doubtful: ["?", "wait"], unreachable: ["▲", "bad"], failing: ["▲", "bad"], lost: ["✗", "bad"],
};
const WORST_FIRST = ["lost", "unreachable", "failing", "doubtful", "off", "well"];
const AGAIN_MILLIS = 1000;

/** The signs of life as they were told last; events tell of changes alone, and ages go on. */
let signs = null;
let isAsking = false;
/** What is shown; it is made anew when something else was told. */
let drawn = [];

function mark(row) {
  const [sign, tone] = SIGNS[row.state] ?? ["?", "wait"];
  return make("span", { class: `state ${tone}`, "data-sign": sign }, row.state);
}

function entry(row, name, about) {
  const tone = SIGNS[row.state]?.[1];
  return make("li", { class: `standing ${tone}`, "data-name": row.container ?? row.agent ?? row.member ?? row.part, "data-state": row.state },
    make("p", { class: "head" }, name, mark(row)),
    about ? make("p", { class: "quiet" }, about) : null,
    row.why ? make("p", { class: "why" }, row.why) : null);
}

function count(rows) {
  const on = rows.filter((row) => row.state !== "off");
  const bad = on.filter((row) => row.state !== "well").length;
  return bad === 0 ? (on.length > 1 ? `all ${on.length} well` : "") : `${bad} of ${on.length} not well`;
}

function block(title, rows, made) {
  const ordered = [...rows].sort((a, b) => WORST_FIRST.indexOf(a.state) - WORST_FIRST.indexOf(b.state));
  return make("section", { class: "block", "aria-label": title },
    make("h2", {}, title, make("span", { class: "quiet counts" }, count(rows))),
    make("ul", {}, ordered.map(made)));
}

const PARTS = { bus: "Bus: the broker between agents and members", journal: "Journal: what outlives the process" };

function silence(row) {
  const told = signs?.containers.find((one) => one.container === row.container && one.process === row.process) ?? row;
  return `last sign of life ${seconds(told.silence_s)} ago`;
}

function container(row) {
  const agents = row.agents.length === 0 ? "no agents" : row.agents.join(", ");
  return entry(row, make("strong", {}, row.container), `${row.process}, ${silence(row)}: ${agents}`);
}

function member(row) {
  const name = make("button", { type: "button", class: "row", onclick: () => select({ view: "members", thing: row.member }) }, row.member);
  return entry(row, name, `depends on the agent ${row.agent}`);
}

/** What a person would have to know to trust a green mark. */
function bound({ sign_every_s: every, doubtful_after_s: doubtful, lost_after_s: lost, shown_within_s: within }) {
  return `What a process's death or freeze changes stands here within T = ${within} s: each container gives a sign of life every ${every} s, `
    + `is doubtful after ${doubtful} s of silence and lost after ${lost} s; what is found is told within a second.`;
}

async function askAgain() {
  if (!isAsking) {
    isAsking = true;
    try {
      signs = await ask.states();
    } catch {
      // That the platform does not answer is said above all views.
    }
    setTimeout(() => { isAsking = false; }, AGAIN_MILLIS);
  }
}

export function drawStates() {
  const told = state.states;
  const all = byId("states-all");
  if (told === null) {
    redraw(all, make("p", { class: "empty" }, "Nothing was told yet."));
    return;
  }
  if (!document.hidden) {
    askAgain();
  }
  const now = [told, signs, selection().at];
  if (now.every((one, i) => one === drawn[i])) {
    return;
  }
  drawn = now;
  byId("states-bound").textContent = bound(told.timing) + (selection().at === null ? "" : " States have no past: this is now.");
  redraw(all,
    make("div", { class: "column" },
      block("What all depend on", told.parts, (row) => entry(row, make("strong", {}, PARTS[row.part]))),
      block("Containers", told.containers, container)),
    block("Agents", told.agents, (row) => entry(row, make("strong", {}, row.agent), `in ${row.container}`)),
    block("Members", told.members, member));
}
