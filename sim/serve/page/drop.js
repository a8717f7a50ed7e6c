// Files that are dropped on the page, or chosen, are put into the folder; over what is there only when that is asked for.

import { post } from '/watch.js';

const LARGEST = 200 * 1024;

/** `tell`: { say(sentence, bad), ask(question, yes), listed() }. */
export async function put(files, tell) {
  for (const file of files) {
    if (file.size > LARGEST) {
      tell.say(`${file.name} has ${Math.ceil(file.size / 1024)} KB; at most 200 are taken`, true);
      continue;
    }
    await one(file.name, await file.text(), false, tell);
  }
}

async function one(name, text, replace, tell) {
  try {
    const answer = await post('/api/file', { name, text, replace });
    const { saved } = await answer.json();
    await tell.listed();
    tell.say(`${saved.slice(2)} is in the folder now`);
  } catch (error) {
    if (error.message.endsWith('already')) tell.ask(`${error.message}.`, 'Replace it', () => one(name, text, true, tell));
    else tell.say(error.message, true);
  }
}
