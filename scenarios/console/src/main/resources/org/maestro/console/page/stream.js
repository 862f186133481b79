/** The page of what one member streams: which it is stands behind the # of its address. */
import { byId } from "./dom.js";
import { ask, listen } from "./feed.js";

const PICTURES = new Set(["image/png", "image/jpeg"]);
const SOUND = /^audio\/L16;rate=([1-9][0-9]{0,5});channels=1$/;
const FULL_SCALE = 32768;
/** So long a page waits for the next frame before it says that nothing streams. */
const PATIENCE_MILLIS = 5000;
/** Sound is played a little later than it comes, so that it does not break off when some comes late. */
const AHEAD_SECONDS = 0.2;
const LINK = {
  connecting: "connecting",
  live: "live",
  lost: "The platform does not answer.",
  closed: "This site wants to know who looks: sign in at the console as an operator, and open this page again.",
};

let streamer = "";
let label = "";
let leave = () => {};
let last = null;
let missed = 0;
let quiet = 0;
let player = null;
let playedUntil = 0;

function name() {
  byId("streamer").textContent = streamer === "" ? "A stream" : label;
  document.title = `MAESTRO – ${streamer === "" ? "stream" : label}`;
}

function showNothing() {
  byId("shown").hidden = true;
  const nothing = byId("nothing");
  nothing.hidden = false;
  nothing.textContent = streamer === ""
    ? "Name the camera or microphone behind the address of this page, such as stream.html#cam-kitchen."
    : `${label.charAt(0).toUpperCase()}${label.slice(1)} streams nothing now. It is begun by a call, such as ./maestro stream ${streamer}, and seen here for as long as that goes on.`;
}

function samples(data) {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length >> 1 }, (_, i) => view.getInt16(2 * i) / FULL_SCALE);
}

function play(heard, rate) {
  const buffer = player.createBuffer(1, heard.length, rate);
  buffer.copyToChannel(heard, 0);
  const source = player.createBufferSource();
  source.buffer = buffer;
  source.connect(player.destination);
  playedUntil = Math.max(playedUntil, player.currentTime + AHEAD_SECONDS);
  source.start(playedUntil);
  playedUntil += buffer.duration;
}

function showSound(data, rate) {
  const heard = samples(data);
  byId("strength").value = Math.sqrt(heard.reduce((sum, one) => sum + one * one, 0) / Math.max(1, heard.length));
  if (player !== null && heard.length > 0) {
    play(heard, rate);
  }
}

function show(frame) {
  const sound = SOUND.exec(frame.type);
  const isPicture = PICTURES.has(frame.type);
  byId("nothing").hidden = true;
  byId("shown").hidden = false;
  byId("picture").hidden = !isPicture;
  byId("strength").hidden = sound === null;
  byId("sound").hidden = sound === null;
  if (isPicture) {
    byId("picture").src = `data:${frame.type};base64,${frame.data}`;
    byId("picture").alt = `What ${label} has in view`;
  } else if (sound !== null) {
    showSound(frame.data, Number(sound[1]));
  }
  missed = last?.call === frame.call ? missed + Math.max(0, frame.number - last.number - 1) : 0;
  last = frame;
  const at = new Date(frame.captured_at).toLocaleTimeString([], { hour12: false });
  byId("told").textContent = `captured at ${at}, at the platform ${frame.delay_ms} ms later; frame ${frame.number}, ${missed} not shown`;
  clearTimeout(quiet);
  quiet = setTimeout(showNothing, PATIENCE_MILLIS);
}

function link(how) {
  const element = byId("link");
  element.textContent = LINK[how];
  element.className = `link ${how === "closed" ? "lost" : how}`;
}

function follow() {
  leave();
  clearTimeout(quiet);
  streamer = decodeURIComponent(location.hash.slice(1));
  label = streamer;
  last = null;
  name();
  showNothing();
  ask.home().then((home) => {
    label = home.things.find((thing) => thing.name === streamer)?.label ?? streamer;
    name();
    if (last === null) {
      showNothing();
    }
  }, () => {});
  leave = streamer === "" ? () => {} : listen("streams", show, { of: streamer, link });
}

function theme(chosen) {
  document.documentElement.dataset.theme = chosen;
  localStorage.setItem("theme", chosen);
}

theme(localStorage.getItem("theme") ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
byId("theme").addEventListener("click", () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
byId("sound").addEventListener("click", () => {
  if (player === null) {
    player = new AudioContext();
    playedUntil = 0;
  } else {
    player.close();
    player = null;
  }
  byId("sound").setAttribute("aria-pressed", String(player !== null));
});
window.addEventListener("hashchange", follow);
follow();
