// A map or a robot as text, changed in the page: where there is no editor for files, as on a phone.

const $ = (id) => document.getElementById(id);
const ENDING = { map: 'map', robot: 'toml' };

export class TextEditor {
  /** `textOf(kind)`: { name, text } of what is chosen; `use(kind, { name, bytes })`: takes the user's own for it. */
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
