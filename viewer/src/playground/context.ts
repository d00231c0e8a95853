// Place of the cursor in a TOML text: path of the table, keys of the table, and whether a key or a value is written.

export interface Context {
  /** Path of the table. */
  path: string[];
  /** Value of the key `kind` of the table. */
  kind: string | null;
  /** Key whose value is written; null for keys. */
  key: string | null;
  /** Text of the key or value before the cursor. */
  written: string;
}

const HEADER = /^\s*\[\[?\s*([^\]]+?)\s*\]\]?/;
const splitKeys = (text: string) => text.split(".").map((key) => key.trim().replace(/^["']|["']$/g, ""));

/** Innermost inline table that is open at the end of a text: path below the table, and its entries so far. */
function inlineTable(text: string): { path: string[]; entries: string } {
  const stack: { path: string[]; start: number }[] = [];
  let [quote, start] = ["", 0];
  for (let i = 0; i < text.length; i++) {
    const c = text[i];
    if (quote) {
      if (c === quote) quote = "";
    } else if (c === '"' || c === "'") quote = c;
    else if (c === "{") {
      const name = text.slice(start, i).match(/([\w.-]+)\s*=\s*(\[\s*)?$/)?.[1];
      stack.push({ path: name ? splitKeys(name) : [], start: i + 1 });
      start = i + 1;
    } else if (c === "}") start = stack.pop()?.start ?? 0;
  }
  return { path: stack.flatMap((level) => level.path), entries: text.slice(stack.at(-1)?.start ?? 0) };
}

const kindIn = (text: string) => text.match(/(?:^|[\n{,])\s*kind\s*=\s*["']([^"']*)["']/)?.[1] ?? null;

/** Context of the cursor; null within comments. */
export function contextAt(text: string, cursor: number): Context | null {
  const lines = text.slice(0, cursor).split("\n");
  let header = lines.length - 1;
  while (header >= 0 && !HEADER.test(lines[header])) header--;
  if (header === lines.length - 1 && header >= 0) return null;
  const table = header >= 0 ? splitKeys(lines[header].match(HEADER)?.[1] ?? "") : [];
  const current = lines.at(-1) ?? "";
  if (/^\s*#/.test(current)) return null;
  // An inline array of tables may begin in an earlier line.
  const before = lines.slice(header + 1).join("\n");
  const { path, entries } = inlineTable(before);
  const rest = text.slice(cursor).split("\n");
  const below = rest.findIndex((line, number) => number > 0 && HEADER.test(line));
  const after = (below < 0 ? rest : rest.slice(0, below)).join("\n");
  const inline = path.length > 0;
  const kind = inline ? kindIn(entries + (rest[0].split("}")[0] ?? "")) : kindIn(`${before}${after}`);
  const entry = (inline ? entries.split(",").at(-1) : current) ?? "";
  const [, key, written] = entry.match(/^\s*([\w.-]+)\s*=\s*(\S*)$/) ?? [];
  if (key !== undefined) {
    const keys = splitKeys(key);
    return { path: [...table, ...path, ...keys.slice(0, -1)], kind, key: keys.at(-1) ?? null, written };
  }
  const name = entry.match(/^\s*([\w.-]*)$/)?.[1];
  if (name === undefined) return null;
  const keys = splitKeys(name);
  return { path: [...table, ...path, ...keys.slice(0, -1)], kind, key: null, written: keys.at(-1) ?? "" };
}
