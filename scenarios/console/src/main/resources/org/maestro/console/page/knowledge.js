/** What is known: questions, and the whole list. */
import { make, byId, table, redraw, seconds } from "./dom.js";
import { state, ask } from "./feed.js";
import { facts } from "./detail.js";

export function drawKnowledge() {
  const known = [...state.facts.values()];
  redraw(byId("fact-list"), known.length > 0
    ? facts(known)
    : make("p", { class: "empty" }, "Nothing is known yet but what the home says. State a goal, and somebody will look."));
}

function bound(answer) {
  return Object.entries(answer.binding)
    .map(([name, value]) => `?${name} = ${Array.isArray(value) ? value.join(" ") : value}`).join(", ");
}

export function startKnowledge() {
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
