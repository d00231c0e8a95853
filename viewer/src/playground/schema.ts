// Queries of the JSON Schema of model files.

export interface Schema {
  description?: string;
  type?: string | string[];
  const?: unknown;
  enum?: unknown[];
  default?: unknown;
  $ref?: string;
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  items?: Schema;
  oneOf?: Schema[];
  anyOf?: Schema[];
  $defs?: Record<string, Schema>;
}

/** Key of a table, or value of a key, with its description. */
export interface Choice {
  label: string;
  detail: string;
  description: string;
}

/** Alternatives of a schema without references. */
function alternatives(root: Schema, schema: Schema): Schema[] {
  if (schema.$ref) {
    const named = root.$defs?.[schema.$ref.replace("#/$defs/", "")];
    return named ? alternatives(root, named) : [];
  }
  const parts = [...(schema.oneOf ?? []), ...(schema.anyOf ?? [])];
  return parts.length > 0 ? parts.flatMap((part) => alternatives(root, part)) : [schema];
}

/** Schemas of the tables at a path of keys. Elements of arrays have the path of the array. */
export function schemasAt(root: Schema, path: string[]): Schema[] {
  let found: Schema[] = [root];
  for (const key of path) {
    found = found.flatMap((schema) => {
      const table = schema.items ? alternatives(root, schema.items) : [schema];
      return table.flatMap((one) => {
        const next = one.properties?.[key] ?? one.additionalProperties;
        return typeof next === "object" ? alternatives(root, next) : [];
      });
    });
  }
  return found.flatMap((schema) => (schema.items ? alternatives(root, schema.items) : [schema]));
}

/** Keeps the alternatives of a kind, if any. */
export function ofKind(schemas: Schema[], kind: string | null): Schema[] {
  const same = schemas.filter((schema) => schema.properties?.kind?.const === kind);
  return kind !== null && same.length > 0 ? same : schemas;
}

const firstSentence = (text = "") => text.split("\n\n")[0];

function typeName(schema: Schema): string {
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.$ref) return schema.$ref.replace("#/$defs/", "");
  return [schema.type ?? []].flat().join(" or ");
}

/** Keys of tables. */
export function keys(schemas: Schema[]): Choice[] {
  const found = new Map<string, Choice>();
  for (const schema of schemas) {
    for (const [label, value] of Object.entries(schema.properties ?? {})) {
      if (found.has(label)) continue;
      found.set(label, { label, detail: typeName(value), description: firstSentence(value.description) });
    }
  }
  return [...found.values()];
}

/** Values of a key of tables, in TOML. */
export function values(root: Schema, schemas: Schema[], key: string): Choice[] {
  const found = new Map<string, Choice>();
  const add = (value: unknown, description = "") => {
    if (!["string", "boolean"].includes(typeof value)) return;
    const label = JSON.stringify(value);
    if (!found.has(label)) found.set(label, { label, detail: "", description: firstSentence(description) });
  };
  for (const schema of schemas) {
    const property = schema.properties?.[key];
    if (!property) continue;
    for (const one of alternatives(root, property)) {
      const description = key === "kind" ? schema.description : one.description;
      if (one.const !== undefined) add(one.const, description);
      for (const value of one.enum ?? []) add(value, one.description);
      if (one.type === "boolean") for (const value of [true, false]) add(value);
    }
  }
  return [...found.values()];
}
