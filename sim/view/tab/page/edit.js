// Edits a map or a robot as text in the page, for devices without a file editor, such as phones.

const $ = (id) => document.getElementById(id);
const ENDING = { map: 'map', robot: 'toml' };

export class TextEditor {
  /** `textOf(kind)` returns { name, text } of the selected map or robot. `use(kind, { name, bytes })` selects
   *  the edited file instead. */
  constructor(textOf, use) {
    for (const kind of Object.keys(ENDING)) $(`edit-${kind}`).addEventListener('click', () => this.open(kind, textOf(kind), use));
    $('own-text').addEventListener('input', () => { this.file.bytes = new TextEncoder().encode($('own-text').value); });
  }

  open(kind, { name, text }, use) {
    const ending = `.${ENDING[kind]}`;
    this.file = { name: name.endsWith(ending) ? name : `my-${name}${ending}`, bytes: new TextEncoder().encode(text) };
    use(kind, this.file);
    $('own-name').textContent = this.file.name;
    $('own-text').value = text;
    $('own').hidden = false;
    $('own-text').focus();
  }
}
