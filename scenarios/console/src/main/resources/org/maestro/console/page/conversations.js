/** What agents say to each other: the latest conversations, and one of them drawn. */
import { make, byId, table, choices, redraw } from "./dom.js";
import { ask, listen } from "./feed.js";
import { select, selection } from "./selection.js";
import { sequence } from "./sequence.js";
import { prettySl } from "./pretty.js";
import { copyButton } from "./copy.js";

const MOST_NAMED = 3;
const SIGNS = {
  open: ["…", "wait"], done: ["✓", "good"], refused: ["✗", "bad"], failed: ["✗", "bad"], cancelled: ["–", ""],
};

let conversations = new Map();
let elsewhere = [];
let end = null;
let drawn = "";
/** The chosen one with its messages, as it was read last. */
let read = { id: null, latest: 0, document: null, problem: null };

/** The stream is heard while its view is looked at. */
function follow(isWanted) {
  if (isWanted && !end) {
    end = listen("conversations", (news, isFirst) => {
      if (isFirst) {
        conversations = new Map();
      }
      news.conversations.forEach((one) => conversations.set(one.id, one));
      conversations.forEach((one, id) => {
        if (one.latest < news.oldest) {
          conversations.delete(id);
        }
      });
      elsewhere = news.elsewhere;
    });
  } else if (!isWanted && end) {
    end();
    end = null;
  }
}

function stateOf(conversation) {
  const [sign, kind] = SIGNS[conversation.state];
  return make("span", { class: `state ${kind}`, "data-sign": sign }, conversation.state);
}

/** What it is about, of contents that say so by these names; of others as they begin. */
function gist({ subject, id }) {
  const head = /^\(+\s*([^\s()]+)/.exec(subject ?? "")?.[1];
  const named = (name) => new RegExp(`\\(:${name} ("[^"]*"|(?:[^()"]|\\([^()]*\\))+)\\)`).exec(subject ?? "")?.[1];
  const parts = [named("goal"), named("features?"), named("member")].filter(Boolean);
  return head && parts.length > 0 ? [head, ...parts].join(" · ") : subject ?? id;
}

/** Who began it, and with whom. */
function parties({ participants: [first, ...others] }) {
  const named = others.slice(0, MOST_NAMED).join(", ");
  const more = others.length - MOST_NAMED;
  return `${first} → ${named}${more > 0 ? ` and ${more} more` : ""}`;
}

function limits() {
  const seen = "What the console asks all the time, to show how things stand, is left out.";
  return elsewhere.length === 0 ? seen
    : `What agents in ${elsewhere.join(", ")} say among themselves is not seen: they live in other processes. ${seen}`;
}

export function drawConversations() {
  follow(true);
  const all = [...conversations.values()].sort((a, b) => b.latest - a.latest);
  const named = (values, none) => [{ value: "", text: none }, ...[...new Set(values)].sort().map((value) => ({ value, text: value }))];
  choices(byId("conversation-agent"), named(all.flatMap((one) => one.participants), "any agent"));
  choices(byId("conversation-protocol"), named(all.map((one) => one.protocol).filter(Boolean), "any"));
  const agent = byId("conversation-agent").value;
  const protocol = byId("conversation-protocol").value;
  const { conversation: chosen } = selection();
  const now = [all.length, all[0]?.latest, agent, protocol, chosen, elsewhere].join(" ");
  if (drawn === now) {
    return;
  }
  drawn = now;
  const found = all.filter((one) => (agent === "" || one.participants.includes(agent)) && (protocol === "" || one.protocol === protocol));
  byId("conversation-count").textContent = found.length === all.length ? `${all.length}` : `${found.length} of ${all.length}`;
  byId("conversation-limits").textContent = limits();
  const list = byId("conversation-list");
  if (found.length === 0) {
    redraw(list, make("p", { class: "empty" }, all.length === 0
      ? "No agent has said anything yet. State a goal, and they will."
      : "No conversation is like that."));
    return;
  }
  const columns = [
    { name: "Conversation", cell: (one) => [
      make("button", { class: "row", type: "button", title: one.subject }, gist(one)),
      make("p", { class: "parties quiet" }, parties(one))] },
    { name: "State", cell: stateOf },
    { name: "Protocol", className: "wide quiet", cell: (one) => (one.protocol ?? "–").replace(/^fipa-/, "") },
    { name: "Said", className: "number", cell: (one) => String(one.messages) },
    { name: "Last", className: "number quiet", cell: (one) => `${one.at_s.toFixed(1)} s` },
  ];
  redraw(list, table(columns, found, {
    isChosen: (one) => one.id === chosen,
    choose: (one) => select({ conversation: one.id, said: null }),
  }));
}

async function fetchWhole(id, latest) {
  const former = read.id === id ? read.document : null;
  read = { id, latest, document: former, problem: null };
  try {
    const document = await ask.conversation(id);
    if (read.id === id) {
      read.document = document;
    }
  } catch (failure) {
    read.problem = failure.message;
  }
  drawConversation();
}

function content(message) {
  return [
    make("h3", {}, make("span", { class: "grow" },
      `${message.performative}, ${message.from} to ${message.to}, at ${message.at_s.toFixed(3)} s`),
    copyButton("Copy content", message.content)),
    make("pre", { tabindex: 0, "aria-label": "Content" },
      message.content === "" ? "It has no content."
        : prettySl(message.content) + (message.shortened ? `\n… (${message.characters} characters)` : "")),
  ];
}

export function drawConversation() {
  const { view, conversation: id, said } = selection();
  if (view !== "conversations") {
    return;
  }
  const detail = byId("detail");
  const told = conversations.get(id);
  if (id && (read.id !== id || (told && told.latest > read.latest))) {
    fetchWhole(id, told?.latest ?? 0);
  }
  const whole = read.id === id ? read.document : null;
  const width = detail.clientWidth - 22;
  const now = ["conversation", id, whole?.latest, whole?.state, said, read.problem, width].join(" ");
  if (detail.dataset.shows === now) {
    return;
  }
  const isSame = detail.dataset.shows?.startsWith(`conversation ${id} `);
  detail.dataset.shows = now;
  if (!whole) {
    detail.replaceChildren(make("p", { class: id && read.problem ? "problem" : "empty" }, id
      ? read.problem ?? "…" : "Choose a conversation to see it drawn: agents as lines, messages as arrows."));
    return;
  }
  const before = isSame ? detail.querySelector(".sequence") : null;
  const place = before ? [before.scrollTop, before.scrollLeft, before.scrollTop + before.clientHeight >= before.scrollHeight - 20] : [0, 0, false];
  const hadFocus = detail.contains(document.activeElement) && document.activeElement.closest(".said") !== null;
  const chosen = whole.sequence.find((message) => String(message.number) === said);
  const diagram = make("div", { class: "sequence", tabindex: 0, "aria-label": "Sequence diagram" },
    sequence(whole, width, said, (number) => select({ said: number })));
  detail.replaceChildren(
    make("h2", {}, make("code", {}, whole.conversation ?? "no conversation id"), stateOf(whole),
      make("span", { class: "quiet counts" }, [whole.protocol ?? "no protocol", ...Object.entries(whole.performatives).map(([name, times]) => `${times} ${name}`)].join(", "))),
    diagram,
    make("div", { class: "content" }, chosen ? content(chosen)
      : make("p", { class: "quiet" }, "Choose a message for what it says.")));
  diagram.scrollTo(place[1], place[2] && whole.state === "open" ? diagram.scrollHeight : place[0]);
  const marked = diagram.querySelector(".said.chosen");
  if (marked) {
    marked.scrollIntoView({ block: "nearest", inline: "nearest" });
    if (hadFocus) {
      marked.focus({ preventScroll: true });
    }
  }
}

export function startConversations() {
  byId("conversation-form").addEventListener("submit", (event) => event.preventDefault());
  byId("conversation-agent").addEventListener("change", drawConversations);
  byId("conversation-protocol").addEventListener("change", drawConversations);
  addEventListener("hashchange", () => follow(selection().view === "conversations"));
  addEventListener("resize", () => drawConversation());
}
