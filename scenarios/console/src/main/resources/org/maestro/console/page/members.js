/** Members and agents: who is there, and where it lives; who was lost stays in the list. */
import { make, byId, table, redraw, choices, seconds } from "./dom.js";
import { state, age, ask } from "./feed.js";
import { select, selection } from "./selection.js";

function phase(agent) {
  const isReady = agent.phase === "ready";
  return make("span", { class: `state ${isReady ? "good" : "bad"}`, "data-sign": isReady ? "●" : "▲" }, agent.phase ?? "–");
}

let offered = null;

function drawForms(rows) {
  const named = (values) => [...new Set(values)].sort().map((value) => ({ value, text: value }));
  choices(byId("agent-name"), named(rows.map((agent) => agent.agent)));
  const { thing } = selection();
  const chosen = rows.find((agent) => agent.members.includes(thing));
  if (chosen && offered !== thing) {
    byId("agent-name").value = chosen.agent;
    offered = thing;
  }
  choices(byId("agent-container"), named(state.agents.map((agent) => agent.container).filter((name) => name && name !== "Main-Container")));
}

/** Orders to the platform; what it says to them stands below. */
export function startMembers() {
  const told = byId("agent-told");
  const order = (id, work) => byId(id).addEventListener("click", async () => {
    told.className = "";
    told.textContent = "…";
    try {
      told.textContent = (await work()).told.join(" ");
    } catch (failure) {
      told.className = "problem";
      told.textContent = failure.message;
    }
  });
  const agent = () => byId("agent-name").value;
  const description = () => byId("agent-description").value;
  order("agent-move", () => ask.moveAgent(agent(), byId("agent-container").value));
  order("agent-remove", () => ask.removeAgent(agent()));
  order("agent-add", () => ask.addAgents(description()));
  order("agent-reconfigure", () => ask.reconfigureAgent(agent(), description()));
  byId("agent-form").addEventListener("submit", (event) => event.preventDefault());
}

export function drawMembers() {
  const rows = state.agents.filter((agent) => agent.members.length > 0);
  drawForms(rows);
  const list = byId("member-list");
  if (rows.length === 0) {
    redraw(list, make("p", { class: "empty" },
      "No device has joined yet. A device joins by describing itself on the bus; docs/guide-bus.md shows how."));
    return;
  }
  const chosen = selection().thing;
  redraw(list, table([
    { name: "Member", cell: (agent) => make("button", { class: "row", type: "button" }, agent.members.join(" ")) },
    { name: "Bus", cell: phase },
    { name: "State", cell: (agent) => agent.state ?? "–" },
    { name: "For", className: "number", cell: (agent) => seconds(age(agent)) },
    { name: "Container", className: "wide", cell: (agent) => agent.container ?? "–" },
    { name: "Can", className: "wide quiet", cell: (agent) => agent.services.join(", ") },
  ], rows, {
    isChosen: (agent) => agent.members.includes(chosen),
    choose: (agent) => select({ thing: agent.members[0] }),
  }));
}
