/** A person's day, in sentences: where she was, what devices were at, and what was asked for. */
import { make, byId, choices } from "./dom.js";
import { ask, state } from "./feed.js";

function sentence({ from, to, text }) {
  const when = to === null || to === from ? from : `${from} – ${to}`;
  return make("li", {}, make("span", { class: "when" }, when), " ", text);
}

async function tell(event) {
  event.preventDefault();
  const problem = byId("day-problem");
  const told = byId("day-told");
  problem.textContent = "";
  try {
    const day = await ask.day(byId("day-person").value, byId("day-date").value);
    told.replaceChildren(make("ol", {}, day.told.map(sentence)),
      day.left_out > 0 ? make("p", { class: "quiet" }, `Left out, as it is private: ${day.left_out}`) : "");
  } catch (failure) {
    told.replaceChildren();
    problem.textContent = failure.message;
  }
}

/** Whose day can be told. */
export function drawDay() {
  choices(byId("day-person"), state.home.things.filter((thing) => thing.classes.includes("Person"))
    .map((thing) => ({ value: thing.name, text: thing.label ?? thing.name })));
}

export function startDay() {
  byId("day-form").addEventListener("submit", tell);
}
