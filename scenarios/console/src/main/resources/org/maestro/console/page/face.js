/** The page of one face: which it is stands behind the # of its address; without, it can be chosen. */
import { byId, make } from "./dom.js";
import { ask, listen } from "./feed.js";
import { mark, portrait } from "./facial.js";

const NOBODY = { persona: null, expression: "neutral", intensity: 0, looksAt: null, turn: null, rise: 0, gesture: null, pointsAt: null, saying: null, stress: 0 };
/** What a face tells of itself, and what that is here. */
const TOLD = {
  appearsAs: (face, fact) => { face.persona = fact.arguments[1]; },
  hasExpression: (face, fact) => { face.expression = fact.arguments[1]; },
  expressionStrength: (face, fact) => { face.intensity = fact.value; },
  looksAt: (face, fact) => { face.looksAt = fact.arguments[1]; },
  gazeTurn: (face, fact) => { face.turn = fact.value; },
  gazeRise: (face, fact) => { face.rise = fact.value; },
  gestures: (face, fact) => { face.gesture = fact.arguments[1]; },
  pointsAt: (face, fact) => { face.pointsAt = fact.arguments[1]; },
  isSaying: (face, fact) => { face.saying = fact.arguments[1]; },
  voiceStress: (face, fact) => { face.stress = fact.value; },
};
const GESTURES = { nod: "nods", shake: "shakes its head" };
const EXPRESSIONS = { smile: "smiles", frown: "frowns", worry: "looks worried" };
const LINK = {
  connecting: "connecting",
  live: "live",
  lost: "The platform does not answer; the face is as it was told last.",
  closed: "This site wants to know who looks: sign in at the console, and open this page again.",
};
/** So long a sentence stays readable when it is over. */
const READABLE_MILLIS = 12000;

const show = portrait(byId("face"));
const faces = new Map();
const labels = new Map();
let chosen = "";
let leave = () => {};
let begun = null;
let forgetting = 0;
let hasSound = false;

function read(facts) {
  const face = { ...NOBODY };
  facts.filter((fact) => fact.value !== false).forEach((fact) => TOLD[fact.word]?.(face, fact));
  return face;
}

const called = (thing) => labels.get(thing) ?? thing;

/** What it does, in words, for who does not see it. */
function inWords(face) {
  const what = [
    EXPRESSIONS[face.expression],
    face.pointsAt === null ? face.looksAt && `looks at ${called(face.looksAt)}` : `points at ${called(face.pointsAt)}`,
    GESTURES[face.gesture],
    face.saying !== null && face.stress > 0 ? "speaks in a stressed voice" : null,
  ].filter(Boolean);
  return what.length === 0 && face.persona === null ? "Nobody has spoken here yet." : what.join(", ");
}

function speak(face, sentence) {
  if (!hasSound || !("speechSynthesis" in window)) {
    return;
  }
  const sound = new SpeechSynthesisUtterance(sentence);
  sound.rate = 1 + 0.25 * face.stress;
  sound.pitch = 0.85 + (mark(face.persona ?? "") % 5) * 0.08 + 0.3 * face.stress;
  speechSynthesis.speak(sound);
}

/** One that was over before it was told is shown all the same; of those before this page was opened none is. */
function tellSentence(face, { sentences, sentence }) {
  const bubble = byId("sentence");
  const isOver = face.saying === null;
  const isBegun = sentence !== undefined && (begun === null ? !isOver : sentences !== begun);
  if (isBegun) {
    speak(face, sentence);
    bubble.textContent = sentence;
    bubble.hidden = false;
  }
  if (!isOver || isBegun) {
    clearTimeout(forgetting);
    forgetting = 0;
  }
  if (isOver && forgetting === 0 && !bubble.hidden) {
    forgetting = setTimeout(() => {
      bubble.hidden = true;
      byId("stage").classList.remove("speaks");
    }, READABLE_MILLIS);
  }
  bubble.classList.toggle("over", isOver);
  byId("stage").classList.toggle("speaks", !bubble.hidden);
  begun = sentences;
}

function drawFace(told) {
  const face = told.there ? read(told.facts) : { ...NOBODY };
  byId("screen").textContent = told.label;
  document.title = `MAESTRO – ${told.label}`;
  byId("persona").textContent = face.persona ?? "";
  const words = told.there ? inWords(face) : "This face is not there.";
  byId("doing").textContent = words;
  byId("face").setAttribute("aria-label", `${face.persona ?? "A face"}: ${words || "is calm"}`);
  show(face);
  tellSentence(face, told);
}

function drawChoice() {
  const names = [...faces.keys()].sort();
  byId("choice-told").textContent = names.length === 0
    ? "No face is there. A home has one with a device of the class :FaceScreen or :Face."
    : chosen === "" ? "Which face is to be seen here?" : `There is no face ${chosen}. There are:`;
  byId("choice-list").replaceChildren(...names.map((name) =>
    make("li", {}, make("a", { href: `#${encodeURIComponent(name)}` }, faces.get(name).label))));
}

function drawAll() {
  const told = faces.get(chosen);
  byId("choice").hidden = told !== undefined;
  byId("portrait").hidden = told === undefined;
  if (told === undefined) {
    drawChoice();
  } else {
    drawFace(told);
  }
}

function link(how) {
  const element = byId("link");
  element.textContent = LINK[how];
  element.className = `link ${how === "closed" ? "lost" : how}`;
}

/** While this page is seen, the face that it shows can do something. */
function follow() {
  leave();
  chosen = decodeURIComponent(location.hash.slice(1));
  faces.clear();
  begun = null;
  leave = listen("faces", (news) => {
    news.faces.forEach((told) => faces.set(told.member, told));
    drawAll();
  }, { of: chosen, link });
}

function theme(name) {
  document.documentElement.dataset.theme = name;
  localStorage.setItem("theme", name);
}

theme(localStorage.getItem("theme") ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
byId("theme").addEventListener("click", () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
const sound = byId("sound");
sound.hidden = !("speechSynthesis" in window);
sound.addEventListener("click", () => {
  hasSound = !hasSound;
  sound.setAttribute("aria-pressed", String(hasSound));
  if (!hasSound) {
    speechSynthesis.cancel();
  }
});
ask.home().then((home) => {
  home.things.forEach((thing) => labels.set(thing.name, thing.label ?? thing.name));
  drawAll();
}, () => {});
window.addEventListener("hashchange", follow);
follow();
