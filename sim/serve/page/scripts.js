// The script of what is run (docs/reference/scripts.md). Of several robots each has its own, and the text is that of the robot that
// is looked at.

export class Scripts {
  /** `box`: its text; `whose`: where the robot's name stands, if there are several. */
  constructor(box, whose) { Object.assign(this, { box, whose, names: [], texts: [], number: 0 }); }

  /** A run is shown, of these robots. */
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
  /** Lines that robot `number` of a run has carried out. */
  add(number, lines) {
    this.keep();
    if (this.names.length) this.texts[number] = joined(this.texts[number], lines);
    if (!this.names.length || number === this.number) this.box.value = joined(this.box.value, lines);
  }
  /** What is run next is not what is shown. */
  forget() {
    if (this.names.length) this.box.value = this.whose.textContent = '';
    this.names = [];
  }
  /** For a request. */
  wanted() {
    this.keep();
    if (!this.names.length) return { script: this.box.value };
    return { scripts: Object.fromEntries(this.names.map((name, i) => [name, this.texts[i]])) };
  }
  keep() { if (this.names.length && this.number !== null) this.texts[this.number] = this.box.value; }
}

const joined = (text, lines) => `${text.trimEnd()}\n${lines}`.trimStart();
