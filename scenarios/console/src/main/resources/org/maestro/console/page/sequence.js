/** A conversation as a sequence diagram: agents as life lines, messages as arrows in their order. */
import { make, draw } from "./dom.js";

const TIMES = 62;
const ROW = 30;
const HEAD = 34;
const NARROWEST = 60;
const WIDEST = 210;
const LETTER = 6;
const MOST = 400;
const GOOD = new Set(["inform", "inform-ref", "agree", "accept-proposal", "confirm"]);
const BAD = new Set(["refuse", "failure", "not-understood", "reject-proposal", "cancel", "disconfirm"]);

function tone(performative) {
  return BAD.has(performative) ? "bad" : GOOD.has(performative) ? "good" : "";
}

function fitting(name, room) {
  const most = Math.floor(room / LETTER);
  return name.length <= most ? name : `${name.slice(0, most - 1)}…`;
}

function arrow(from, to, y) {
  if (from === to) {
    return [
      draw("path", { class: "way", d: `M ${from} ${y - 6} h 26 v 10 h -18` }),
      draw("polygon", { class: "tip", points: `${from + 2},${y + 4} ${from + 10},${y} ${from + 10},${y + 8}` }),
    ];
  }
  const back = to > from ? -9 : 9;
  return [
    draw("line", { class: "way", x1: from, y1: y, x2: to + back * 0.8, y2: y }),
    draw("polygon", { class: "tip", points: `${to},${y} ${to + back},${y - 4.5} ${to + back},${y + 4.5}` }),
  ];
}

/**
 * The diagram, in as much width as there is; wider when many take part.
 * @param choose is told the number of a message that is chosen
 */
export function sequence(conversation, room, chosen, choose) {
  const messages = conversation.sequence.slice(-MOST);
  const agents = conversation.participants;
  const lane = Math.max(NARROWEST, Math.min(WIDEST, (room - TIMES - 16) / agents.length));
  const width = Math.ceil(TIMES + lane * agents.length);
  const height = messages.length * ROW + 16;
  const at = new Map(agents.map((agent, i) => [agent, TIMES + lane * (i + 0.5)]));
  const size = (tall) => ({ width, height: tall, viewBox: `0 0 ${width} ${tall}` });
  const heads = draw("svg", { ...size(HEAD), class: "heads", "aria-hidden": "true" },
    agents.flatMap((agent) => [
      draw("rect", { class: "agent", x: at.get(agent) - lane / 2 + 4, y: 4, width: lane - 8, height: HEAD - 10, rx: 5 },
        draw("title", {}, agent)),
      draw("text", { x: at.get(agent), y: HEAD / 2 + 3, "text-anchor": "middle" }, fitting(agent, lane - 10)),
    ]));
  const lines = agents.map((agent) =>
    draw("line", { class: "life", x1: at.get(agent), y1: 0, x2: at.get(agent), y2: height }));
  const isChosen = (message) => String(message.number) === chosen;
  const first = messages.find(isChosen) ?? messages[0];
  const said = messages.map((message, i) => {
    const y = i * ROW + 20;
    const [from, to] = [at.get(message.from), at.get(message.to)];
    return draw("g", {
      class: `said ${tone(message.performative)} ${isChosen(message) ? "chosen" : ""}`,
      role: "button", tabindex: message === first ? 0 : -1, "aria-pressed": String(isChosen(message)),
      "data-number": message.number,
      "aria-label": `${message.at_s.toFixed(1)} s, ${message.from} to ${message.to}: ${message.performative}`,
      onclick: () => choose(message.number),
    },
    draw("rect", { class: "band", x: 0, y: y - 18, width, height: ROW },
      draw("title", {}, `${message.performative}, ${message.from} to ${message.to}: ${message.content.slice(0, 300)}`)),
    draw("text", { class: "time", x: TIMES - 10, y: y + 4, "text-anchor": "end" }, `${message.at_s.toFixed(1)} s`),
    arrow(from, to, y),
    draw("text", { class: "label", x: from === to ? from + 34 : (from + to) / 2, y: from === to ? y + 4 : y - 5, "text-anchor": from === to ? "start" : "middle" },
      message.performative));
  });
  const body = draw("svg", {
    ...size(height), role: "group", "aria-label": "Messages in their order; arrow keys go from one to the next",
    onkeydown: (event) => walk(event, said, choose),
  }, lines, said);
  return [
    messages.length < conversation.sequence.length
      ? make("p", { class: "quiet" }, `The latest ${MOST} of ${conversation.sequence.length} messages are drawn.`) : "",
    heads, body,
  ];
}

function walk(event, said, choose) {
  const index = said.indexOf(event.target.closest(".said"));
  const step = { ArrowDown: 1, ArrowUp: -1, Enter: 0, " ": 0 }[event.key];
  if (index < 0 || step === undefined) {
    return;
  }
  event.preventDefault();
  choose(said[Math.max(0, Math.min(said.length - 1, index + step))].dataset.number);
}
