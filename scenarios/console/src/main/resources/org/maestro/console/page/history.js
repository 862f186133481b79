/** History: charts of what was measured, and the list of what became of goals and members. */
import { byId, make, redraw, seconds } from "./dom.js";
import { ask, state } from "./feed.js";
import { select, selection } from "./selection.js";
import { longTable } from "./list.js";
import { chart } from "./charts.js";
import { drawDay, startDay } from "./day.js";
import { clockTime, happened, keptPast, tone } from "./past.js";

const OFTEN_MILLIS = 3000;
const MOST_IN_ONE = 8;
const WORD = /^\(([^ ]+) ?(.*)\)$/;

const GOALS = { "goals-under-way": "under way", "goals-waiting": "waiting", "goals-reached": "reached or held", "goals-failed": "failed" };
const ANSWERS = { "api-answers": "API", "agents-answers": "agents", "members-answers": "members" };

/** The charts that are drawn, by their keys. */
let drawn = new Map();
let asked = 0;
let isAsking = false;
let wanted = "";

function labelled(name) {
  return state.thingByName.get(name)?.label ?? name;
}

function unitOf(word) {
  return state.words.find((entry) => entry.word === word)?.unit ?? "";
}

/** The numbers under a word, each of one thing. */
function numbers(series, word) {
  return series.filter((name) => WORD.exec(name)?.[1] === word);
}

/** What there is to be drawn: for what is chosen on the map its own numbers, too. */
function plans({ series }) {
  const { thing } = selection();
  const own = thing === null ? [] : series.filter((name) => WORD.exec(name)?.[2].split(" ").includes(thing));
  const light = numbers(series, "illuminance").filter((name) => !own.includes(name));
  return [
    ...own.map((name) => {
      const word = WORD.exec(name)[1];
      return { title: `${word} of ${labelled(thing)}`, unit: unitOf(word), names: { [name]: labelled(thing) } };
    }),
    {
      title: light.length > MOST_IN_ONE ? `Illuminance, ${MOST_IN_ONE} of ${light.length} places` : "Illuminance", unit: unitOf("illuminance") || "lux",
      names: Object.fromEntries(light.slice(0, MOST_IN_ONE).map((name) => [name, labelled(WORD.exec(name)[2])])),
      none: "No light was measured yet.",
    },
    { title: "Detections", unit: "a minute, by the platform's clock", names: { detections: "something is seen, for the first time or again" }, none: "Nothing was counted yet." },
    { title: "Goals", unit: "listed", isCount: true, names: GOALS, none: "Nothing was counted yet." },
    { title: "Answers", unit: "ms until the API, the platform's agents, and members that are called have answered", names: ANSWERS, none: "Nothing was measured yet." },
  ].map((plan) => ({ ...plan, names: Object.fromEntries(Object.entries(plan.names).filter(([name]) => series.includes(name))) }));
}

function chosenSecond() {
  const { at } = selection();
  return at === null ? null : Date.parse(at) / 1000;
}

/** Up to now, or around the time that is shown. */
function span(kept) {
  const length = Number(byId("history-span").value) * 1000;
  const [from, now] = [Date.parse(kept.from), Date.parse(kept.now)];
  if (length === 0) {
    return [from, Math.max(now, from + 1000)];
  }
  const at = chosenSecond();
  const end = at === null ? now : Math.min(now, at * 1000 + length / 2);
  return [Math.max(Math.min(from, end - 1000), end - length), end];
}

function lay(all) {
  const key = JSON.stringify(all.map(({ title, unit, names }) => [title, unit, names]));
  if (key === wanted) {
    return;
  }
  wanted = key;
  drawn.forEach((one) => one.end());
  drawn = new Map(all.filter(({ names }) => Object.keys(names).length > 0).map((plan) => [plan,
    chart(plan, Object.values(plan.names), (second) => select({ at: new Date(second * 1000).toISOString() }))]));
  byId("charts").replaceChildren(...all.map((plan) => [...drawn].find(([one]) => one === plan)?.[1].element
    ?? make("figure", { class: "chart" }, make("figcaption", {}, plan.title), make("p", { class: "empty" }, plan.none))));
}

async function measure() {
  const kept = keptPast();
  if (isAsking || !kept?.from) {
    return;
  }
  isAsking = true;
  asked = performance.now();
  try {
    lay(plans(kept));
    const names = [...drawn.keys()].flatMap((plan) => Object.keys(plan.names));
    const [from, to] = span(kept);
    const told = names.length === 0 ? { at: [], series: [] }
      : await ask.samples(names, new Date(from).toISOString(), new Date(to).toISOString());
    const at = told.at.map((time) => Date.parse(time) / 1000);
    const byName = new Map(told.series.map((one) => [one.name, one]));
    drawn.forEach((one, plan) => {
      const series = Object.keys(plan.names).map((name) => byName.get(name));
      if (series.every(Boolean)) {
        one.draw(at, series, chosenSecond());
      }
    });
  } catch {
    // It is asked again; that the platform does not answer is said elsewhere.
  }
  isAsking = false;
}

const list = make("div", { class: "scroll" });
let listed = null;

/** What became of goals and members, the latest first; a click shows that time. */
export function drawHappened() {
  const detail = byId("detail");
  if (detail.dataset.shows !== "history") {
    detail.dataset.shows = "history";
    detail.replaceChildren(make("h2", {}, "What happened", make("span", { class: "quiet counts" }, "a click shows that time")), list);
  }
  const all = happened();
  if (all === null) {
    redraw(list, make("p", { class: "empty" }, "…"));
  } else if (all.length === 0) {
    redraw(list, make("p", { class: "empty" }, "Nothing has become of a goal or a member yet."));
  } else {
    listed([...all].reverse());
  }
}

export function startHistory() {
  startDay();
  listed = longTable(list, "events", [
    { name: "When", className: "when", text: (event) => clockTime(event.at), value: (event) => event.at, cell: (event) => make("button", { class: "row", type: "button" }, clockTime(event.at)) },
    { name: "Clock", className: "number wide", text: (event) => seconds(event.clock_s), value: (event) => event.clock_s },
    { name: "What", text: (event) => event.what, cell: (event) => make("span", { class: `state ${tone(event)}` }, event.what) },
    { name: "Of", text: (event) => [event.name, event.text].filter(Boolean).join(" ") },
  ], {
    isChosen: (event) => event.at === selection().at,
    choose: (event) => select({ at: event.at }),
  });
  byId("history-span").addEventListener("change", measure);
  new MutationObserver(() => drawn.forEach((one) => one.redraw())).observe(document.documentElement, { attributeFilter: ["data-theme"] });
}

let chosen = "";

export function drawHistory() {
  drawDay();
  const kept = keptPast();
  byId("history-kept").textContent = kept === null ? "" :
    `${(kept.bytes / 2 ** 20).toFixed(1)} of ${kept.most_bytes / 2 ** 20} MiB, ${kept.most_s / 3600} h at most`;
  const now = JSON.stringify([selection().at, selection().thing, byId("history-span").value]);
  if (now !== chosen || performance.now() - asked > OFTEN_MILLIS) {
    chosen = now;
    measure();
  }
}
