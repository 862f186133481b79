/** What is known: questions, and the whole list. */
import { make, byId, table, redraw, seconds } from "./dom.js";
import { state, ask } from "./feed.js";
import { select, selection } from "./selection.js";
import { longTable } from "./list.js";
import { FACTS } from "./detail.js";

let listed = null;

export function drawKnowledge() {
  byId("facts-left-out").hidden = state.leftOut === 0;
  byId("facts-left-out").textContent = `${state.leftOut} more ${state.leftOut === 1 ? "is" : "are"} private, and left out here.`;
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

/** What stands in the home has been so since the platform began, and perhaps for longer. */
function origin({ source, because }) {
  return because[0]?.kind === "described" ? `${source}, since the platform began` : source ?? "–";
}

function answered({ answers }) {
  return [table([
    { name: "Truth", text: (answer) => answer.truth },
    { name: "With", text: (answer) => bound(answer) || "–", cell: (answer) => make("code", {}, bound(answer) || "–") },
    { name: "Age", className: "number", text: (answer) => seconds(answer.age_s) },
    { name: "From", text: origin },
  ], answers)];
}

function found({ variables, rows, whole }) {
  return [
    make("p", { class: "quiet" }, rows.length === 0 ? "Nothing is found." : whole ? `${rows.length} rows` : `The first ${rows.length} rows; ask for less to see all.`),
    rows.length === 0 ? null : table(variables.map((name) => ({ name, text: (row) => row[name] ?? "–" })), rows),
  ].filter(Boolean);
}

const EXAMPLES = [
  ["Where is it?", "(in Cup ?where)"],
  ["Who sees it?", "(canSee ?who Cup)"],
  ["Where is it bright?", "(>= (illuminance ?zone) 72)"],
  ["SPARQL: who has said what", "PREFIX maestro: <https://w3id.org/maestro#> SELECT ?who ?said WHERE { GRAPH ?g { ?o maestro:sourceName ?who ; maestro:fact ?said } }"],
  ["SPARQL: what there is, by class", "SELECT ?class (COUNT(DISTINCT ?thing) AS ?number) WHERE { GRAPH ?g { ?thing a ?class } } GROUP BY ?class ORDER BY DESC(?number)"],
];

export function startKnowledge() {
  listed = longTable(byId("fact-list"), "facts", FACTS, {
    isChosen: (fact) => fact.fact === selection().fact,
    choose: (fact) => select({ fact: fact.fact }),
  });
  const input = byId("question-input");
  const examples = byId("question-example");
  EXAMPLES.forEach(([text, value]) => examples.append(make("option", { value }, text)));
  examples.addEventListener("change", () => {
    if (examples.value) {
      input.value = examples.value;
      examples.value = "";
      input.focus();
    }
  });
  const problem = byId("question-problem");
  byId("question-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    problem.textContent = "";
    byId("answers").replaceChildren();
    const question = input.value.trim();
    try {
      byId("answers").replaceChildren(...(question.startsWith("(") ? answered(await ask.know(question)) : found(await ask.query(question))));
    } catch (failure) {
      problem.textContent = failure.message;
    }
  });
}
