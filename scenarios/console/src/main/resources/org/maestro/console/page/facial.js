/** A face drawn as it is to be: it moves towards that, breathes, blinks, and moves its mouth while it speaks. */
import { draw } from "./dom.js";

/** How each expression is, at its strongest; what is left out is 0. */
const EXPRESSIONS = {
  neutral: { curve: 0.16 },
  smile: { curve: 1, cheek: 1, squint: 0.34, lift: 6 },
  frown: { curve: -0.72, knit: 5, lift: -4, squint: 0.12 },
  worry: { curve: -0.34, knit: -17, lift: 9, drop: 1, wide: 0.12, narrow: 0.3 },
};
const REST = { curve: 0.16, cheek: 0, squint: 0, lift: 0, knit: 0, drop: 0, wide: 0, narrow: 0, shut: 0, x: 0, y: 0, arm: 0, tilt: 0 };
const SPEED = { x: 9, y: 9, arm: 7, shut: 12, tilt: 6 };
const USUAL_SPEED = 8;
const GESTURE_SECONDS = 0.9;
const BLINK_SECONDS = 0.17;
/** Degrees at which the eyes are as far aside as they go. */
const FAR_ASIDE = 55;
const FAR_UP = 40;
const SYLLABLES_PER_SECOND = 4.2;
const QUICKER_UNDER_STRESS = 0.25;
const NEAR = 0.002;

const clamp = (value, least, most) => Math.max(least, Math.min(most, value));

/** The same number for the same name, everywhere. */
export function mark(name) {
  return [...name].reduce((sum, letter) => (sum * 31 + letter.codePointAt(0)) % 9973, 7);
}

/** What a persona wears on its head, so that who confuses colours knows it, too. */
const ORNAMENTS = [
  () => [draw("path", { class: "stalk", d: "M200 52 V18" }), draw("circle", { class: "ornament", cx: 200, cy: 14, r: 12 })],
  () => [draw("circle", { class: "ornament", cx: 62, cy: 196, r: 26 }), draw("circle", { class: "ornament", cx: 338, cy: 196, r: 26 })],
  () => [draw("path", { class: "ornament", d: "M84 112 C98 22 302 22 316 112 C268 74 132 74 84 112 Z" })],
  () => [draw("path", { class: "stalk", d: "M148 60 L126 22" }), draw("circle", { class: "ornament", cx: 124, cy: 19, r: 10 }),
    draw("path", { class: "stalk", d: "M252 60 L274 22" }), draw("circle", { class: "ornament", cx: 276, cy: 19, r: 10 })],
  () => [draw("path", { class: "ornament", d: "M150 62 C160 20 196 34 200 10 C212 32 248 24 250 62 Z" })],
];

function eye(x, name) {
  const clip = draw("ellipse", { cx: x, cy: 186, rx: 33, ry: 39 });
  const white = draw("ellipse", { class: "white", cx: x, cy: 186, rx: 32, ry: 38 });
  const ball = draw("g", {}, draw("circle", { class: "iris", cx: x, cy: 186, r: 20 }), draw("circle", { class: "pupil", cx: x, cy: 186, r: 11 }),
    draw("circle", { class: "glint", cx: x + 7, cy: 178, r: 5.5 }), draw("circle", { class: "glint", cx: x - 6, cy: 193, r: 2.6 }));
  const upper = draw("path", { class: "lid" });
  const lower = draw("ellipse", { class: "lid", cx: x, cy: 266, rx: 52, ry: 40 });
  const lash = draw("path", { class: "lash" });
  const parts = draw("g", {},
    draw("clipPath", { id: name }, clip),
    draw("g", { "clip-path": `url(#${name})` }, white, ball, lower, upper), lash);
  return { parts, clip, white, ball, upper, lower, lash, x };
}

/** Makes the drawing within an SVG element; what is returned is told how the face is. */
export function portrait(svg) {
  const isCalm = matchMedia("(prefers-reduced-motion: reduce)");
  const left = eye(148, "eye-left");
  const right = eye(252, "eye-right");
  const brows = [draw("path", { class: "brow", d: "M-30 4 Q0 -12 30 2" }), draw("path", { class: "brow", d: "M-30 2 Q0 -12 30 4" })];
  const cheeks = [draw("ellipse", { class: "cheek", cx: 112, cy: 246, rx: 26, ry: 16 }), draw("ellipse", { class: "cheek", cx: 288, cy: 246, rx: 26, ry: 16 })];
  const lips = draw("path", { class: "lips" });
  const inside = draw("path", {});
  const tongue = draw("ellipse", { class: "tongue", cx: 200, rx: 30, ry: 17 });
  const drop = draw("path", { class: "drop", d: "M318 104 C330 124 334 134 326 144 C320 151 308 148 307 138 C306 130 312 120 318 104 Z" });
  const ornament = draw("g");
  const features = draw("g", {}, cheeks, left.parts, right.parts, brows, lips,
    draw("clipPath", { id: "within-lips" }, inside), draw("g", { "clip-path": "url(#within-lips)" }, tongue));
  const head = draw("g", {},
    draw("path", { fill: "url(#skin)", d: "M200 46 C296 46 336 104 336 192 C336 288 288 342 200 342 C112 342 64 288 64 192 C64 104 104 46 200 46 Z" }),
    ornament, features, drop);
  const hand = draw("g", {},
    draw("rect", { class: "hand", x: -4, y: -9, width: 62, height: 18, rx: 9 }),
    draw("path", { class: "hand", d: "M-34 -22 C-14 -34 14 -28 16 -14 L16 20 C10 32 -22 34 -36 22 Z" }),
    draw("rect", { class: "hand", x: -22, y: -30, width: 34, height: 15, rx: 7.5, transform: "rotate(-24)" }));
  svg.replaceChildren(
    draw("defs", {}, draw("radialGradient", { id: "skin", cx: "42%", cy: "32%", r: "78%" },
      draw("stop", { class: "skin-high", offset: "55%" }), draw("stop", { class: "skin-low", offset: "100%" }))),
    draw("ellipse", { class: "shadow", cx: 200, cy: 436, rx: 150, ry: 10 }),
    draw("rect", { class: "neck", x: 166, y: 322, width: 68, height: 60, rx: 22 }),
    draw("path", { class: "shirt", d: "M62 436 C66 386 122 364 164 362 C180 384 220 384 236 362 C278 364 334 386 338 436 Z" }),
    head, hand);

  let wanted = { ...REST };
  let now = { ...REST };
  let shown = { persona: null, expression: "neutral", intensity: 0, turn: null, rise: 0, gesture: null, pointsAt: null, saying: null, stress: 0 };
  let gestureAt = -1;
  let speaksSince = 0;
  let blinkAt = -1;
  let before = 0;
  let frame = 0;

  /** 0 to 1: closed to wide open; by no means the sounds of the words. */
  function mouth(seconds) {
    if (shown.saying === null) {
      return 0;
    }
    if (isCalm.matches) {
      return 0.5;
    }
    const beat = (seconds - speaksSince) * Math.PI * SYLLABLES_PER_SECOND * (1 + QUICKER_UNDER_STRESS * shown.stress);
    return 0.12 + 0.5 * Math.abs(Math.sin(beat)) + 0.26 * Math.abs(Math.sin(beat * 0.37 + 1));
  }

  function moved(seconds) {
    const passed = (seconds - gestureAt) / GESTURE_SECONDS;
    if (gestureAt < 0 || passed > 1 || isCalm.matches) {
      return { x: 0, y: 0 };
    }
    const swing = Math.sin(passed * Math.PI * 4) * Math.sin(passed * Math.PI);
    return shown.gesture === "shake" ? { x: swing * 26, y: 0 } : { x: 0, y: Math.abs(swing) * 30 };
  }

  /** The lids meet below the middle of the eye. */
  function drawEye(part, open) {
    const half = 39 + 30 * now.wide;
    const closed = (1 - open) * (2 * half - 20);
    const edge = 186 - half + 15 + closed;
    const bow = edge - 30 + 44 * (1 - open);
    part.clip.setAttribute("ry", half);
    part.white.setAttribute("ry", half - 1);
    part.ball.setAttribute("transform", `translate(${now.x * 14} ${now.y * 16})`);
    part.upper.setAttribute("d", `M${part.x - 40} 80 H${part.x + 40} V${edge + 4} Q${part.x} ${bow - 3} ${part.x - 40} ${edge + 4} Z`);
    part.lower.setAttribute("cy", 186 + half + 42 - 58 * now.squint);
    part.white.setAttribute("opacity", open < 0.02 ? 0 : 1);
    part.lash.setAttribute("d", `M${part.x - 30} ${edge} Q${part.x} ${bow} ${part.x + 30} ${edge}`);
  }

  function drawMouth(open) {
    const half = (62 + 12 * Math.max(0, now.curve) - 26 * now.narrow) * (1 - 0.2 * open);
    const y = 276;
    const corner = y - 12 * now.curve;
    const upper = y + 30 * now.curve - 10 * open;
    const lower = y + 34 * now.curve + 64 * open;
    const path = `M${200 - half} ${corner} Q200 ${upper} ${200 + half} ${corner} Q200 ${lower} ${200 - half} ${corner} Z`;
    lips.setAttribute("d", path);
    inside.setAttribute("d", path);
    tongue.setAttribute("cy", (corner + lower) / 2 + 16);
    tongue.setAttribute("opacity", clamp((open - 0.2) * 4, 0, 1));
  }

  function drawHand() {
    const side = now.tilt < 0 ? -1 : 1;
    const up = clamp(-wantedRise(), -40, 40) * side;
    hand.setAttribute("transform", `translate(${200 + side * 148} ${470 - 96 * now.arm}) scale(${side} 1) rotate(${up * side})`);
    hand.setAttribute("opacity", clamp(now.arm * 2, 0, 1));
  }

  const wantedRise = () => (shown.pointsAt === null ? 0 : shown.rise);

  function paint(seconds) {
    const gesture = moved(seconds);
    const blink = blinkAt < 0 || isCalm.matches ? 0 : clamp(1 - Math.abs((seconds - blinkAt) / BLINK_SECONDS - 1), 0, 1);
    const open = clamp((1 - now.shut) * (1 - blink), 0, 1);
    const breath = isCalm.matches ? 0 : Math.sin(seconds * 1.5) * 1.6;
    head.setAttribute("transform", `translate(${gesture.x * 0.35 + now.x * 5} ${breath + gesture.y * 0.35}) rotate(${now.x * 2.6} 200 340)`);
    features.setAttribute("transform", `translate(${now.x * 14 + gesture.x} ${now.y * 10 + gesture.y})`);
    drawEye(left, open);
    drawEye(right, open);
    brows.forEach((brow, i) => brow.setAttribute("transform",
      `translate(${i === 0 ? 148 : 252} ${122 - now.lift + 6 * now.shut}) rotate(${(i === 0 ? 1 : -1) * now.knit})`));
    cheeks.forEach((cheek) => cheek.setAttribute("opacity", 0.12 + 0.5 * clamp(now.cheek, 0, 1)));
    drop.setAttribute("opacity", clamp(now.drop * 1.4 - 0.3, 0, 1));
    drawMouth(mouth(seconds));
    drawHand();
  }

  function isMoving(seconds) {
    return Object.keys(REST).some((name) => Math.abs(wanted[name] - now[name]) > NEAR)
      || shown.saying !== null || seconds - gestureAt < GESTURE_SECONDS || !isCalm.matches;
  }

  function step(millis) {
    const seconds = millis / 1000;
    const passed = clamp(seconds - before, 0, 0.1);
    before = seconds;
    for (const name of Object.keys(REST)) {
      const share = isCalm.matches ? 1 : 1 - Math.exp(-passed * (SPEED[name] ?? USUAL_SPEED));
      now[name] += (wanted[name] - now[name]) * share;
    }
    if (blinkAt >= 0 && seconds - blinkAt > 2 * BLINK_SECONDS) {
      blinkAt = -1;
    }
    paint(seconds);
    frame = isMoving(seconds) ? requestAnimationFrame(step) : 0;
  }

  function go() {
    if (frame === 0) {
      frame = requestAnimationFrame(step);
    }
  }

  setInterval(() => {
    if (!document.hidden && !isCalm.matches && Math.random() < 0.35) {
      blinkAt = performance.now() / 1000;
    }
  }, 1000);
  isCalm.addEventListener("change", go);

  return (face) => {
    const seconds = performance.now() / 1000;
    if (face.gesture !== null && face.gesture !== shown.gesture) {
      gestureAt = seconds;
    }
    if (face.saying !== null && face.saying !== shown.saying) {
      speaksSince = seconds;
    }
    if (face.persona !== shown.persona) {
      const number = mark(face.persona ?? "");
      svg.style.setProperty("--hue", String((number * 101) % 360));
      ornament.replaceChildren(...(face.persona === null ? [] : ORNAMENTS[number % ORNAMENTS.length]()));
    }
    shown = { ...face, gesture: face.gesture ?? (seconds - gestureAt < GESTURE_SECONDS ? shown.gesture : null) };
    const strongest = EXPRESSIONS[face.expression] ?? EXPRESSIONS.neutral;
    const strength = face.expression === "neutral" ? 1 : 0.35 + 0.65 * face.intensity;
    wanted = { ...REST };
    for (const [name, value] of Object.entries(strongest)) {
      wanted[name] = REST[name] + (value - REST[name]) * strength;
    }
    // Its own left is at the right of who looks at it.
    wanted.x = face.turn === null ? 0 : clamp(face.turn / FAR_ASIDE, -1, 1);
    wanted.y = face.turn === null ? 0 : clamp(-face.rise / FAR_UP, -1, 1);
    wanted.arm = face.pointsAt === null ? 0 : 1;
    wanted.tilt = face.turn === null ? 0 : Math.sign(face.turn);
    wanted.shut = face.persona === null && face.expression === "neutral" ? 1 : 0;
    go();
  };
}
