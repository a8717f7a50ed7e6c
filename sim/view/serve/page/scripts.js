// Stores the script for the next run (docs/reference/scripts.md). If there are several robots, each robot has
// a script. The text box then shows the script of the selected robot.

export class Scripts {
  /** `box` shows the text. If there are several robots, `whose` shows the name of the selected robot. */
  constructor(box, whose) { Object.assign(this, { box, whose, names: [], texts: [], number: 0 }); }

  /** Uses the scripts of a shown run's robots. */
  show(runs) {
    if (runs.length < 2) return this.forget();
    this.names = runs.map((run) => run.name);
    this.texts = runs.map((run) => run.header.script ?? '');
    this.number = null;
  }
  lookAt(number) {
    if (!this.names.length) return;
    this.keep();
    this.number = number;
    this.box.value = this.texts[number];
    this.whose.textContent = ` of ${this.names[number]}`;
  }
  /** Adds lines that robot `number` of a run has executed. */
  add(number, lines) {
    this.keep();
    if (this.names.length) this.texts[number] = joined(this.texts[number], lines);
    if (!this.names.length || number === this.number) this.box.value = joined(this.box.value, lines);
  }
  /** Forgets the robots, because the next run may have other robots. */
  forget() {
    if (this.names.length) this.box.value = this.whose.textContent = '';
    this.names = [];
  }
  /** Returns the scripts for a request. */
  wanted() {
    this.keep();
    if (!this.names.length) return { script: this.box.value };
    return { scripts: Object.fromEntries(this.names.map((name, i) => [name, this.texts[i]])) };
  }
  keep() { if (this.names.length && this.number !== null) this.texts[this.number] = this.box.value; }
}

const joined = (text, lines) => `${text.trimEnd()}\n${lines}`.trimStart();
