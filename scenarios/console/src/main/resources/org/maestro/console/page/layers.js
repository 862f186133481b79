/** The places of a plan's steps: each in the column after the last one that it needs, the same ones for the same plan. */

/** What each step needs directly: what another one that it needs has needed is left away. */
function directNeeds(steps) {
  const before = new Map();
  const needs = new Map();
  for (const step of steps) {
    const after = step.after.filter((number) => before.has(number));
    const implied = new Set(after.flatMap((number) => [...before.get(number)]));
    needs.set(step.number, after.filter((number) => !implied.has(number)));
    before.set(step.number, new Set([...after, ...implied]));
  }
  return needs;
}

/**
 * @param steps in an order in which each comes after those that it needs
 * @param size of a step, and of the gaps between: { width, height, across, down }
 * @returns places by the steps' numbers, edges as the points they go through, and how large it all is
 */
export function layers(steps, size) {
  const needs = directNeeds(steps);
  const column = new Map();
  const columns = [];
  const put = (at, item) => { (columns[at] ??= []).push(item); };
  steps.forEach(({ number }) => {
    column.set(number, Math.max(-1, ...needs.get(number).map((other) => column.get(other))) + 1);
    put(column.get(number), { number, from: [], tall: size.height });
  });
  const items = new Map(columns.flat().map((item) => [item.number, item]));
  const edges = steps.flatMap(({ number }) => needs.get(number).map((other) => {
    // What goes past other columns has a place of its own there, so that it crosses no step.
    const way = [items.get(other)];
    for (let at = column.get(other) + 1; at < column.get(number); at += 1) {
      const bend = { number, from: [way.at(-1)], tall: size.down };
      put(at, bend);
      way.push(bend);
    }
    items.get(number).from.push(way.at(-1));
    return { from: other, to: number, way: [...way, items.get(number)] };
  }));
  const tall = (list) => list.reduce((sum, item) => sum + item.tall + size.down, -size.down);
  const height = Math.max(0, ...columns.map(tall));
  columns.forEach((list, at) => {
    const wish = (item) => (item.from.length === 0 ? 0 : item.from.reduce((sum, one) => sum + one.y + one.tall / 2, 0) / item.from.length);
    list.sort((a, b) => wish(a) - wish(b) || a.number - b.number);
    let y = (height - tall(list)) / 2;
    list.forEach((item) => {
      item.x = at * (size.width + size.across);
      item.y = y;
      y += item.tall + size.down;
    });
  });
  return {
    places: items,
    edges,
    width: Math.max(0, columns.length * (size.width + size.across) - size.across),
    height,
  };
}
