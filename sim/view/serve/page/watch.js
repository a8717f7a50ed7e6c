// Watches a run live: receives server-sent events, and sends requests (docs/howto/serving.md). A recording's
// page, empty at first, shows the run (sim/view/page/live.js).

const headers = { 'Content-Type': 'application/json', 'X-Robosim': '1' };

export async function post(path, what, signal) {
  const answer = await fetch(path, { method: 'POST', headers, body: JSON.stringify(what), signal });
  if (!answer.ok) throw new Error((await answer.json()).error);
  return answer;
}

/** Loads a Robosim page without a run into the frame. */
const empty = (frame) => new Promise((done) => {
  frame.onload = () => {
    const ready = setInterval(() => {
      if (!frame.contentWindow?.robosimLive) return;
      clearInterval(ready);
      done(frame.contentWindow.robosimLive);
    }, 10);
  };
  frame.src = `/live.html?${Date.now()}#live`;
});

export class Watch {
  /** `tell` has the functions say(text), begun(page), did(lines, agent), refused(sentence) and gone(). */
  constructor(frame, tell) {
    Object.assign(this, { frame, tell, page: null, feed: null, header: null, early: [], asked: Promise.resolve() });
  }

  /** Watches a run to its end. Returns { status, recording, sentence }. */
  async run(wanted) {
    const answer = await post('/api/live', wanted);
    this.number = (await answer.json()).live;
    const begins = await empty(this.frame);
    return new Promise((done) => {
      const source = this.source = new EventSource(`/api/live/${this.number}`);
      this.close = () => { source.close(); done(null); };
      source.onmessage = ({ data }) => {
        const message = JSON.parse(data);
        if (message.done) {
          source.close();
          done(message.done);
        } else {
          this.take(message, begins);
        }
      };
      source.onerror = () => {  // prevents reconnecting, since the run has ended with the connection
        source.close();
        this.tell.gone();
        done(null);
      };
    });
  }

  take(message, begins) {
    if (message.say) this.tell.say(message.say);
    if (message.accepted) this.tell.did(message.accepted.lines, message.accepted.agent ?? 0);
    if (message.refused) this.tell.refused(message.refused);
    if (message.recording) this.header = message.recording;
    if (!this.feed && message.paused && this.header) {
      ({ page: this.page, feed: this.feed } = begins(this.header, message.paused));
      this.page.player.ask = (request) => this.ask(request);
      for (const one of this.early) this.feed.take(one);
      this.tell.begun(this.page);
      this.page.player.play();
    } else if (this.feed) {
      this.feed.take(message);
    } else if (message.event) {
      this.early.push(message);
    }
  }

  /** Sends requests one after the other, since simultaneous requests may arrive in any order. */
  ask(request) {
    this.asked = this.asked.then(() => post(`/api/live/${this.number}`, { id: 1, ...request }))
      .catch((error) => this.tell.refused(error.message));
  }
}
