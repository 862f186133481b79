/** Text of programs, laid out for people: JSON, and MAESTRO-SL. */
const WIDTH = 64;

export function prettyJson(text) {
  try {
    return JSON.stringify(JSON.parse(text), null, 2);
  } catch {
    return text;
  }
}

/** The lists within a text, as arrays; atoms and strings as they stand. */
function parsed(text) {
  const tokens = text.match(/"(?:[^"\\]|\\.)*"|[()]|[^\s()"]+/g) ?? [];
  const stack = [[]];
  for (const token of tokens) {
    if (token === "(") {
      stack.push([]);
    } else if (token === ")") {
      const list = stack.pop();
      stack.at(-1).push(list);
    } else {
      stack.at(-1).push(token);
    }
  }
  return stack;
}

function flat(node) {
  return Array.isArray(node) ? `(${node.map(flat).join(" ")})` : node;
}

function laidOut(node, indent) {
  const line = flat(node);
  if (!Array.isArray(node) || indent + line.length <= WIDTH || node.length < 2) {
    return line;
  }
  const pad = " ".repeat(indent + 2);
  const isHeaded = !Array.isArray(node[0]);
  const [head, ...rest] = isHeaded ? node : [laidOut(node[0], indent + 1), ...node.slice(1)];
  return `(${head}${rest.map((part) => `\n${pad}${laidOut(part, indent + 2)}`).join("")})`;
}

export function prettySl(text) {
  try {
    const stack = parsed(text);
    return stack.length === 1 ? stack[0].map((node) => laidOut(node, 0)).join("\n") : text;
  } catch {
    return text;
  }
}
