// Saves files that the user has dropped on the page, or selected, in the served folder. Replaces existing
// files only on request.

import { post } from '/watch.js';

const LARGEST_KB = 200, LARGEST_IMAGE_KB = 2048;

const base64 = (file) => new Promise((done, failed) => {
  const reader = new FileReader();
  reader.onload = () => done(reader.result.slice(reader.result.indexOf(',') + 1));
  reader.onerror = () => failed(new Error(`${file.name} cannot be read`));
  reader.readAsDataURL(file);
});

/** Saves files. `tell` has the functions say(sentence, bad), ask(question, yes, then), listed() and
 *  put(place). */
export async function put(files, tell) {
  for (const file of files) {
    const image = /\.(hex|elf)$/.test(file.name), most = image ? LARGEST_IMAGE_KB : LARGEST_KB;
    if (file.size > most * 1024) {
      tell.say(`${file.name} is too large: expected at most ${most} KB, got ${Math.ceil(file.size / 1024)} KB`, true);
      continue;
    }
    const content = image ? { base64: await base64(file) } : { text: await file.text() };
    await one({ name: file.name, ...content, replace: false }, tell);
  }
}

async function one(file, tell) {
  try {
    const answer = await post('/api/file', file);
    const { saved } = await answer.json();
    await tell.listed();
    tell.put(saved);
    tell.say(`${saved.slice(2)} is now in the folder`);
  } catch (error) {
    if (error.message.endsWith('already')) tell.ask(`${error.message}.`, 'Replace it', () => one({ ...file, replace: true }, tell));
    else tell.say(error.message, true);
  }
}
