/** The bus: its messages as they come, newest first, and what is wrong with them. */
import { make, byId } from "./dom.js";
import { ask, listen } from "./feed.js";
import { select, selection } from "./selection.js";
import { prettyJson } from "./pretty.js";
import { copyButton } from "./copy.js";

const MOST = 1000;
const MOST_SHOWN = 300;

let messages = [];
let isListening = true;
let end = null;
/** What is shown while no more is to come in; null: all that comes. */
let paused = null;
let drawn = "";
/** A row stays the same element, so that a click on it is not lost while others come. */
const rows = new Map();

/** The stream is heard while its view is looked at. */
function follow(isWanted) {
  if (isWanted && !end) {
    end = listen("bus", (news, isFirst) => {
      isListening = news.listening;
      if (isFirst) {
        messages = [];
      }
      messages = [...messages, ...news.messages].slice(-MOST);
    });
  } else if (!isWanted && end) {
    end();
    end = null;
  }
}

/** Below the site's own part, which is always the same. */
function shortTopic(topic) {
  return topic.replace(/^rats\/1\/[^/]+\//, "");
}

const GISTS = {
  call: (body) => (body.r ? `${body.f} → ${body.r}` : body.f), result: (body) => body.outcome?.toLowerCase(), status: (body) => body.status,
  state: (body) => body.z, observation: (body) => body.f,
  progress: (body) => `${body.kind?.toLowerCase()} ${Math.round((body.fraction ?? 0) * 100)} %`,
  verdict: (body) => (body.accepted ? "accepted" : "refused"),
};

/** What it comes down to, where that can be read. */
function gist(message) {
  if (message.bytes === 0) {
    return message.retained || message.kind ? "withdrawn" : "empty";
  }
  try {
    return String(GISTS[message.kind]?.(JSON.parse(message.payload)) ?? "");
  } catch {
    return "";
  }
}

function row(message) {
  const known = rows.get(message.number);
  if (known) {
    return known;
  }
  const made = make("tr", { onclick: () => select({ message: message.number }), class: message.problem ? "wrong" : null },
    make("td", { class: "number quiet", title: message.at }, `${message.at_s.toFixed(1)} s`),
    make("td", {},
      make("button", { class: "row", type: "button", title: message.topic }, shortTopic(message.topic)),
      message.problem ? make("p", { class: "problem" }, message.problem) : null),
    make("td", {}, gist(message)),
    make("td", { class: "number quiet wide" }, String(message.bytes)));
  rows.set(message.number, made);
  return made;
}

function wanted(message, text, onlyWrong) {
  return (!onlyWrong || message.problem)
    && (text === "" || `${message.topic} ${message.payload} ${message.problem ?? ""}`.toLowerCase().includes(text));
}

export function drawBus() {
  follow(true);
  const text = byId("bus-filter").value.trim().toLowerCase();
  const onlyWrong = byId("bus-wrong").checked;
  const { message: chosen } = selection();
  const source = paused ?? messages;
  const now = [source.length, source.at(-1)?.number, text, onlyWrong, chosen, isListening, messages.at(-1)?.number].join(" ");
  if (drawn === now) {
    return;
  }
  drawn = now;
  const found = source.filter((message) => wanted(message, text, onlyWrong));
  const shown = found.slice(-MOST_SHOWN).reverse();
  const kept = new Set(source.map((message) => message.number));
  [...rows.keys()].filter((number) => !kept.has(number)).forEach((number) => rows.delete(number));
  const waiting = paused ? messages.filter((message) => message.number > (paused.at(-1)?.number ?? 0)).length : 0;
  byId("bus-pause").textContent = paused ? `Go on${waiting > 0 ? ` (${waiting} new)` : ""}` : "Pause";
  byId("bus-pause").setAttribute("aria-pressed", String(paused !== null));
  byId("bus-count").textContent = found.length === source.length
    ? `${source.length} messages${found.length > MOST_SHOWN ? `, the latest ${MOST_SHOWN} shown` : ""}`
    : `${found.length} of ${source.length}${found.length > MOST_SHOWN ? `, the latest ${MOST_SHOWN} shown` : ""}`;
  const problem = byId("bus-problem");
  problem.hidden = isListening;
  problem.textContent = isListening ? "" : "There is no connection to the broker; what is said meanwhile is missed.";
  shown.forEach((message) => row(message).classList.toggle("chosen", String(message.number) === chosen));
  const list = byId("bus-list");
  if (shown.length === 0) {
    list.replaceChildren(make("p", { class: "empty" },
      source.length === 0 ? "Nothing was said on the bus yet." : "No message is like that."));
    return;
  }
  const body = list.querySelector("tbody") ?? table(list);
  const active = document.activeElement;
  const top = list.scrollTop;
  const height = list.scrollHeight;
  body.replaceChildren(...shown.map(row));
  if (active && body.contains(active)) {
    active.focus({ preventScroll: true });
  }
  // Who reads further down is not moved by what comes in above.
  list.scrollTop = top > 0 ? top + list.scrollHeight - height : 0;
}

function table(list) {
  const body = make("tbody");
  list.replaceChildren(make("table", { class: "bus" },
    make("thead", {}, make("tr", {},
      make("th", { scope: "col", class: "number" }, "Time"), make("th", { scope: "col" }, "Topic"),
      make("th", { scope: "col" }, "What"), make("th", { scope: "col", class: "number wide" }, "Bytes"))),
    body));
  return body;
}

const whole = new Map();

/** The whole of a message; it may be gone from the platform, and is shown as it was told then. */
async function fetchWhole(message) {
  whole.clear();
  whole.set(message.number, message);
  if (message.shortened) {
    try {
      whole.set(message.number, await ask.busMessage(message.number));
    } catch (failure) {
      whole.set(message.number, { ...message, gone: failure.message });
    }
    delete byId("detail").dataset.shows;
    drawBusMessage();
  }
}

export function drawBusMessage() {
  const detail = byId("detail");
  const { message: number } = selection();
  const told = [...(paused ?? []), ...messages].find((message) => String(message.number) === number);
  const shown = whole.get(Number(number)) ?? told;
  const now = `bus ${number} ${shown ? "" : "gone"}`;
  if (detail.dataset.shows === now) {
    return;
  }
  detail.dataset.shows = now;
  if (!shown) {
    detail.replaceChildren(make("p", { class: "empty" }, number
      ? "This message is not kept any more; choose another."
      : "Choose a message for what it says."));
    return;
  }
  if (!whole.has(shown.number)) {
    fetchWhole(shown);
  }
  const entry = (name, value) => [make("dt", {}, name), make("dd", {}, value)];
  detail.replaceChildren(
    make("h2", {}, make("code", {}, shown.topic), make("span", { class: "grow" }),
      copyButton("Copy topic", shown.topic), copyButton("Copy payload", shown.payload)),
    shown.problem ? make("p", { class: "problem", role: "alert" }, shown.problem) : "",
    make("dl", { class: "facts" },
      entry("Kind", shown.kind ?? "none of the bus"),
      entry("From", shown.from ?? "not said by the topic"),
      entry("To", shown.to ?? "everybody"),
      entry("Retained", shown.retained ? "it came with the flag" : "it came without the flag"),
      entry("Size", `${shown.bytes} bytes`),
      entry("Heard", `${new Date(shown.at).toLocaleTimeString()}, at ${shown.at_s.toFixed(3)} s of simulated time`)),
    shown.gone ? make("p", { class: "problem" }, shown.gone) : "",
    make("pre", { tabindex: 0, "aria-label": "Payload" },
      prettyJson(shown.payload) + (shown.shortened ? "\n…" : "")));
  detail.scrollTop = 0;
}

export function startBus() {
  byId("bus-form").addEventListener("submit", (event) => event.preventDefault());
  byId("bus-filter").addEventListener("input", drawBus);
  byId("bus-wrong").addEventListener("change", drawBus);
  byId("bus-pause").addEventListener("click", () => {
    paused = paused ? null : messages;
    drawn = "";
    drawBus();
  });
  addEventListener("hashchange", () => follow(selection().view === "bus"));
}
