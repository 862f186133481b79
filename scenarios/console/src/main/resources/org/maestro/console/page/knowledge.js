/** What is known: questions, and the whole list. */
import { make, byId, table, redraw, seconds } from "./dom.js";
import { state, ask } from "./feed.js";
import { longTable } from "./list.js";
import { FACTS } from "./detail.js";

let listed = null;

export function drawKnowledge() {
  if (state.facts.size === 0) {
    redraw(byId("fact-list"), make("p", { class: "empty" }, "Nothing is known yet but what the home says. State a goal, and somebody will look."));
  } else {
    listed([...state.facts.values()]);
  }
}

function bound(answer) {
  return Object.entries(answer.binding)
    .map(([name, value]) => `?${name} = ${Array.isArray(value) ? value.join(" ") : value}`).join(", ");
}

export function startKnowledge() {
  listed = longTable(byId("fact-list"), "facts", FACTS);
  const problem = byId("question-problem");
  byId("question-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    problem.textContent = "";
    byId("answers").replaceChildren();
    try {
      const { answers } = await ask.know(byId("question-input").value.trim());
      byId("answers").replaceChildren(table([
        { name: "Truth", cell: (answer) => answer.truth },
        { name: "With", cell: (answer) => make("code", {}, bound(answer) || "–") },
        { name: "Age", className: "number", cell: (answer) => seconds(answer.age_s) },
        { name: "From", cell: (answer) => answer.source ?? "–" },
      ], answers));
    } catch (failure) {
      problem.textContent = failure.message;
    }
  });
}
