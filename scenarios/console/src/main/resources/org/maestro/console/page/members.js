/** Members and agents: who is there, and where it lives; who was lost stays in the list. */
import { make, byId, redraw, choices, wholeSeconds } from "./dom.js";
import { longTable } from "./list.js";
import { state, age, ask } from "./feed.js";
import { select, selection } from "./selection.js";

function phase(agent) {
  const isReady = agent.phase === "ready";
  return make("span", { class: `state ${isReady ? "good" : "bad"}`, "data-sign": isReady ? "●" : "▲" }, agent.phase ?? "–");
}

let offered = null;
let listed = null;

function startList() {
  listed = longTable(byId("member-list"), "members", [
    { name: "Member", text: (agent) => agent.members.join(" "), cell: (agent) => make("button", { class: "row", type: "button" }, agent.members.join(" ")) },
    { name: "Bus", text: (agent) => agent.phase ?? "–", cell: phase },
    { name: "State", text: (agent) => agent.state ?? "–" },
    { name: "For", className: "number", text: (agent) => wholeSeconds(age(agent)), value: age },
    { name: "Container", className: "wide", text: (agent) => agent.container ?? "–" },
    { name: "Can", className: "wide quiet", text: (agent) => agent.services.join(", ") },
  ], {
    isChosen: (agent) => agent.members.includes(selection().thing),
    choose: (agent) => select({ thing: agent.members[0] }),
  });
}

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
  startList();
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
  listed(rows);
}
