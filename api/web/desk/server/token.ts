// The server's token, as a person typed it: it goes with what is posted and nowhere else. It is
// kept in memory alone: a page that is loaded anew has forgotten it.

const WANTED = "The server does this for its own machine, or for who shows the server's token.";
const WRONG = 'The server does not take this token. Is all of it there, and of this server?';
const NOT_TYPED = 'Found no token; expected letters, digits and signs without spaces or accents.';

export class Token {
  was_refused = false;
  private text = '';

  /** What is wrong with what was typed, in words; null where it can be sent. */
  give(typed: string): string | null {
    const text = typed.trim();
    if (!/^[!-~]+$/.test(text)) return NOT_TYPED; // no field of a request could carry it
    this.text = text;
    return null;
  }
  get headers(): Record<string, string> {
    return this.text === '' ? {} : { Authorization: `Bearer ${this.text}` };
  }
  /** What a 401 means for a request with these headers. A wrong token is not sent again. */
  refused(sent: Record<string, string>): string {
    this.was_refused = sent.Authorization !== undefined;
    if (!this.was_refused) return WANTED;
    if (sent.Authorization === this.headers.Authorization) this.text = '';
    return WRONG;
  }
}
