/** Chat: a conversation with a person of the home, in a room of it. What is understood of words is decided elsewhere. */
import { make, byId, choices } from "./dom.js";
import { state, ask, listen } from "./feed.js";
import { select, selection } from "./selection.js";
import { clockTime } from "./past.js";
import { drawQuestion } from "./question.js";

const MOST = 2000;
const MOST_SHOWN = 200;
const SIGNS = {
  spoken: ["❝", ""], shown: ["☺", "quiet"], understood: ["▷", ""], told: ["·", "quiet"], asked: ["?", "wait"], reached: ["✓", "good"], ended: ["✗", "bad"], misunderstood: ["✗", "bad"],
};
const WORDS = {
  spoken: "", shown: "", understood: "Understood", told: "", asked: "Asked back", reached: "Done", ended: "Not done", misunderstood: "Not understood",
};

let entries = [];
let end = null;
let drawn = "";

/** The stream is heard while its view is looked at. */
function follow(isWanted) {
  if (isWanted && !end) {
    end = listen("chat", (news, isFirst) => {
      entries = [...(isFirst ? [] : entries), ...news.entries].slice(-MOST);
    });
  } else if (!isWanted && end) {
    end();
    end = null;
  }
}

function named(className) {
  return state.home.things.filter((thing) => thing.classes.includes(className)).map((thing) => ({ value: thing.name, text: thing.label ?? thing.name }));
}

/** What is chosen and there, or else the first. */
function chosen(list, name) {
  return list.find((one) => one.value === name)?.value ?? list[0]?.value ?? null;
}

function offer(text) {
  return make("button", { type: "button", class: "offer", onclick: () => {
    byId("chat-text").value = text;
    byId("chat-text").focus();
  } }, text);
}

function goalButton(goal) {
  return make("button", { type: "button", class: "row", title: "Its story", onclick: () => select({ goal }) }, goal);
}

function line(entry) {
  if (entry.kind === "said") {
    return make("li", { class: "said-by-person" },
      make("p", { class: "quiet" }, `${entry.person}, in ${entry.room}, ${clockTime(entry.at)}`),
      make("p", { class: "bubble" }, entry.text));
  }
  const [sign, tone] = SIGNS[entry.kind] ?? ["·", ""];
  return make("li", { class: `answer ${entry.kind}` },
    make("p", {},
      make("span", { class: `state ${tone}`, "data-sign": sign }, entry.question === null ? WORDS[entry.kind] : "Asks"), " ",
      entry.goal ? [goalButton(entry.goal), " "] : "",
      entry.kind === "understood" && entry.text.startsWith("(") ? make("code", {}, entry.text) : make("span", {}, entry.text)),
    entry.near.length > 0
      ? make("p", { class: "near" }, make("span", { class: "quiet" }, entry.kind === "asked" ? "One of:" : "Near it:"), " ", entry.near.map(offer))
      : null);
}

/** Something of this home that can be said. */
function examples(person) {
  const item = state.home.things.find((thing) => thing.classes.includes("Item"));
  return item ? [", such as: ", offer(`${item.label} next to me`), " or ", offer(`(nextTo ${item.name} ${person})`),
    "; with a question mark it is asked: ", offer(`? in ${item.name}`)] : ".";
}

/** What is said in the room is for all who are there. */
function drawLines(person, room) {
  const all = entries.filter((entry) => (entry.person === null ? entry.room === null || entry.room === room : entry.person === person));
  drawQuestion(all, person);
  const its = all.filter((entry) => entry.kind !== "answered").slice(-MOST_SHOWN);
  const now = `${person} ${room} ${its.length} ${its.at(-1)?.number} ${state.home.label}`;
  if (drawn === now) {
    return;
  }
  drawn = now;
  const log = byId("chat-log");
  const isAtEnd = log.scrollTop + log.clientHeight >= log.scrollHeight - 40;
  log.replaceChildren(its.length === 0
    ? make("p", { class: "empty" }, "Nothing was said yet. Say what is to be so, in the home's words or in MAESTRO-SL", examples(person))
    : make("ul", {}, its.map(line)));
  if (isAtEnd || its.at(-1)?.kind === "said") {
    log.scrollTop = log.scrollHeight;
  }
}

export function drawChat() {
  follow(true);
  const persons = named("Person");
  const rooms = named("Room");
  const person = chosen(persons, selection().person);
  choices(byId("chat-person"), persons);
  choices(byId("chat-room"), rooms);
  byId("chat-person").value = person ?? "";
  byId("chat-room").value = chosen(rooms, selection().room) ?? "";
  const problem = byId("chat-home-problem");
  problem.textContent = person === null ? "This home has no person; whoever is to speak here has to be in its description."
    : rooms.length === 0 ? "This home has no room; where somebody speaks has to be in its description." : "";
  problem.hidden = problem.textContent === "";
  drawLines(person, byId("chat-room").value);
}

async function say(event) {
  event.preventDefault();
  const input = byId("chat-text");
  const problem = byId("chat-problem");
  problem.textContent = "";
  const text = input.value.trim();
  if (text === "") {
    problem.textContent = "Write something first.";
    return;
  }
  input.value = "";
  try {
    await ask.say(byId("chat-person").value, byId("chat-room").value, text);
  } catch (failure) {
    problem.textContent = failure.message;
    input.value ||= text;
  }
}

export function startChat() {
  byId("chat-form").addEventListener("submit", say);
  byId("chat-person").addEventListener("change", ({ target }) => select({ person: target.value }));
  byId("chat-room").addEventListener("change", ({ target }) => select({ room: target.value }));
  addEventListener("hashchange", () => follow(selection().view === "chat"));
}
