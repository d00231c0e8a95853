// Editor of the model text: TOML with completion from the schema and marks of errors.

import { autocompletion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { type Diagnostic, lintGutter, setDiagnostics } from "@codemirror/lint";
import type { Text } from "@codemirror/state";
import { keymap } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { basicSetup, EditorView } from "codemirror";
import { contextAt } from "./context";
import type { Problem } from "./messages";
import { type Choice, keys, ofKind, type Schema, schemasAt, values } from "./schema";

const COLOURS = HighlightStyle.define([
  { tag: tags.comment, class: "code-comment" },
  { tag: tags.string, class: "code-string" },
  { tag: [tags.number, tags.bool, tags.atom], class: "code-number" },
  { tag: [tags.propertyName, tags.definition(tags.name)], class: "code-key" },
]);

/** Completion of keys and values. */
function completion(schema: Schema) {
  return (context: CompletionContext): CompletionResult | null => {
    const place = contextAt(context.state.doc.toString(), context.pos);
    if (!place || (place.written === "" && !context.explicit && place.key === null)) return null;
    const tables = ofKind(schemasAt(schema, place.path), place.key === "kind" ? null : place.kind);
    const choices = place.key === null ? keys(tables) : values(schema, tables, place.key);
    if (choices.length === 0) return null;
    const options = choices.map(({ label, detail, description }: Choice) => {
      const apply = place.key === null && !label.includes(" ") ? `${label} = ` : label;
      return { label, detail, info: description, apply, type: place.key === null ? "property" : "constant" };
    });
    return { from: context.pos - place.written.length, options, validFor: /^["'\w.-]*$/ };
  };
}

/** Range of a problem in the document. */
function diagnostic(doc: Text, problem: Problem): Diagnostic {
  const line = doc.line(Math.min(Math.max(1, problem.line), doc.lines));
  const from = Math.min(line.from + problem.column - 1, line.to);
  const to = Math.min(Math.max(from + problem.length, from), doc.length);
  const { severity, message } = problem;
  return to > from ? { from, to, severity, message } : { from: line.from, to: line.to, severity, message };
}

export class ModelEditor {
  private readonly view: EditorView;

  constructor(parent: Element, schema: Schema, changed: () => void, run: () => void) {
    const started = () => {
      run();
      return true;
    };
    this.view = new EditorView({
      parent,
      extensions: [
        keymap.of([{ key: "Mod-Enter", run: started }]),
        basicSetup,
        StreamLanguage.define(toml),
        syntaxHighlighting(COLOURS),
        lintGutter(),
        autocompletion({ override: [completion(schema)] }),
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ "aria-label": "model file" }),
        EditorView.updateListener.of((update) => update.docChanged && changed()),
      ],
    });
    // Long texts scroll by keys, too.
    this.view.scrollDOM.tabIndex = 0;
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  set text(text: string) {
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text } });
    this.view.scrollDOM.scrollTop = 0;
  }

  /** Marks the problems of the text. */
  mark(problems: Problem[]): void {
    const { doc } = this.view.state;
    this.view.dispatch(
      setDiagnostics(
        this.view.state,
        problems.map((problem) => diagnostic(doc, problem)),
      ),
    );
  }

  /** Moves the cursor to a problem. */
  goTo(problem: Problem): void {
    const { from } = diagnostic(this.view.state.doc, problem);
    this.view.dispatch({ selection: { anchor: from }, scrollIntoView: true });
    this.view.focus();
  }
}
