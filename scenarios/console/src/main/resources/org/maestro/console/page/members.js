/** Members and agents: who is there, and where it lives; who was lost stays in the list. */
import { make, byId, table, redraw, seconds } from "./dom.js";
import { state, age } from "./feed.js";
import { select, selection } from "./selection.js";

function phase(agent) {
  const isReady = agent.phase === "ready";
  return make("span", { class: `state ${isReady ? "good" : "bad"}`, "data-sign": isReady ? "●" : "▲" }, agent.phase ?? "–");
}

export function drawMembers() {
  const rows = state.agents.filter((agent) => agent.members.length > 0);
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
