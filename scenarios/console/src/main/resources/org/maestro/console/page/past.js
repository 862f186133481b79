/** Looking back: the time that is shown, how far back it can be, and what happened until now. */
import { byId, draw, redraw, seconds } from "./dom.js";
import { ask, changed, show } from "./feed.js";
import { select, selection, onSelect } from "./selection.js";
import { mayNot } from "./session.js";

const OFTEN_MILLIS = 5000;
const SELDOM_MILLIS = 30000;
const PASSING_MILLIS = 100;
const WIDTH = 1000;
const REASON = "Not while you look back: it would act now. Go back to now first.";
const BAD = new Set(["failed", "lost", "refused", "left"]);
const GOOD = new Set(["reached", "joined", "returned"]);

/** How far it goes back, as it was told last. */
let kept = null;
let heard = 0;

/** What happened, for as long as somebody looks at that: a day of it is much to keep; null: not asked for yet. */
let events = null;

/** The time that is shown, and what is wrong with that; it differs from the chosen one as long as that is being asked for. */
let shown = null;
let problem = null;
let isAsking = false;

/** Where the slider is, as long as that is not chosen yet. */
let passing = null;

export function isPast() {
  return selection().at !== null;
}

export function keptPast() {
  return kept;
}

/** All of them, oldest first; null as long as they are not told. */
export function happened() {
  return events;
}

export function tone(event) {
  return BAD.has(event.what) ? "bad" : GOOD.has(event.what) ? "good" : "wait";
}

/** As the clock on the wall here says it. */
export function clockTime(time) {
  return new Date(time).toLocaleTimeString("en-GB");
}

/** The platform's clock, in seconds, at a time. */
export function clockAt(time) {
  return kept === null ? Infinity : kept.clock_s - ((Date.parse(kept.now) - Date.parse(time)) / 1000) * kept.speed;
}

/** Why what takes this role cannot be done now; null when it can. */
function objection(role) {
  return mayNot(role) ?? (isPast() ? REASON : null);
}

/** Attributes of a button that acts, which takes this role. */
export function acting(role = "operator") {
  const why = objection(role);
  return { "data-acts": role, disabled: why !== null, title: why };
}

function present() {
  return kept === null ? Date.now() : Date.parse(kept.now) + (performance.now() - heard);
}

function isLooking() {
  return isPast() || selection().view === "history";
}

async function refresh() {
  try {
    const told = await ask.kept();
    heard = performance.now();
    kept = told;
    if (!isLooking()) {
      events = null;
    } else if (told.from === null) {
      events = [];
    } else {
      const before = events ?? [];
      const begin = before.length === 0 ? told.from : before[before.length - 1].at;
      const news = (await ask.happened(begin, new Date(Date.parse(told.now) + 1000).toISOString())).events;
      // Those of the moment that was told last come again.
      events = [...before.filter((event) => event.at >= told.from && event.at < begin), ...news];
    }
  } catch {
    // What the past is now is asked for again; that the platform does not answer is said elsewhere.
  }
}

/** Asks for the chosen time, one after the other: of those passed over quickly only the last counts. */
async function follow() {
  if (isAsking) {
    return;
  }
  isAsking = true;
  while (selection().at !== shown) {
    const { at } = selection();
    let past = null;
    let wrong = null;
    if (at !== null) {
      try {
        past = await ask.past(at);
        wrong = past.recorded ? null : "Nothing was recorded at this time; what is shown was so before.";
      } catch (failure) {
        wrong = failure.message;
        past = { home: null, facts: [], former: [], goals: [], agents: [] };
      }
    }
    shown = at;
    problem = wrong;
    show(past);
  }
  isAsking = false;
}

/** Browsers let an address change some twenty times a second, and answers take a while, too. */
function pass(second, last) {
  if (passing === null) {
    setTimeout(() => {
      const chosen = passing;
      passing = null;
      choose(...chosen);
    }, PASSING_MILLIS);
  }
  passing = [second, last];
}

/** At the end of the slider is now. */
function choose(second, last) {
  const at = Math.min(Date.parse(kept.from) + second * 1000, present());
  select({ at: second >= last ? null : new Date(at).toISOString() }, { isPassing: true });
}

function step(by) {
  const at = selection().at ?? new Date(present()).toISOString();
  const other = by < 0 ? events?.filter((event) => event.at < at).pop() : events?.find((event) => event.at > at);
  if (other) {
    select({ at: other.at });
  }
}

function marks(from, length) {
  const drawn = new Map();
  for (const event of events ?? []) {
    const x = Math.round(((Date.parse(event.at) - from) / length) * WIDTH);
    drawn.set(`${x} ${tone(event)}`, draw("line", { class: `mark ${tone(event)}`, x1: x, x2: x, y1: 0, y2: 10 }));
  }
  return [...drawn.values()];
}

/** What is said to who listens, which is not said again every second; and what goes on by itself. */
function told(at) {
  if (at === null) {
    return kept?.from ? ["Now.", `It is ${clockTime(present())}; the past goes back to ${clockTime(kept.from)}.`] : ["Nothing is recorded yet.", ""];
  }
  const ago = seconds(Math.max(0, (present() - Date.parse(at)) / 1000));
  const clock = kept === null ? "" : `; ${seconds(Math.max(0, clockAt(at)))} by the platform's clock`;
  return [`As of ${clockTime(at)}`, `(${ago} ago${clock}). Until you go back to now, all that acts is off but Safe state.`];
}

function write(id, text) {
  const element = byId(id);
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

function drawActs() {
  document.querySelectorAll("[data-acts]").forEach((control) => {
    const why = objection(control.dataset.acts);
    control.dataset.title ??= control.title;
    control.disabled = why !== null;
    control.title = why ?? control.dataset.title;
  });
}

export function drawPast() {
  const { view, at } = selection();
  const bar = byId("time");
  bar.hidden = view !== "history" && at === null;
  bar.classList.toggle("past", shown !== null);
  drawActs();
  if (bar.hidden) {
    return;
  }
  const [said, more] = told(shown);
  write("time-at", said);
  write("time-ago", more);
  byId("time-now").hidden = at === null;
  write("time-problem", problem ?? kept?.problem ?? "");
  byId("time-problem").hidden = byId("time-problem").textContent === "";
  const slider = byId("time-slider");
  slider.disabled = !kept?.from;
  if (kept?.from) {
    const from = Date.parse(kept.from);
    const length = Math.max(1000, present() - from);
    const value = at === null ? Math.ceil(length / 1000) : Math.round((Date.parse(at) - from) / 1000);
    if (passing === null) {
      slider.max = Math.ceil(length / 1000);
      slider.value = value;
    }
    slider.setAttribute("aria-valuetext", at === null ? "now" : `${clockTime(at)}, ${seconds((present() - Date.parse(at)) / 1000)} ago`);
    redraw(byId("time-marks"), marks(from, length));
  }
}

export function startPast() {
  byId("time-slider").addEventListener("input", ({ target }) => pass(Number(target.value), Number(target.max)));
  byId("time-now").addEventListener("click", () => select({ at: null }));
  byId("time-back").addEventListener("click", () => step(-1));
  byId("time-on").addEventListener("click", () => step(1));
  onSelect(follow);
  let next = 0;
  const again = async () => {
    if (!document.hidden && performance.now() >= next) {
      next = performance.now() + (isLooking() ? OFTEN_MILLIS : SELDOM_MILLIS);
      await refresh();
      changed();
    }
    setTimeout(again, 500);
  };
  onSelect(() => { next = Math.min(next, performance.now() + (isLooking() && events === null ? 0 : OFTEN_MILLIS)); });
  again();
  follow();
}
