// What a stranger writes where a name belongs: each text would call planted(n), ask another host, or make an element, in a page
// that takes it for markup, script, an address, a template or Markdown. n is the number of its field.

/** Every trick in one line; markup of elements, attributes, scripts, styles, comments and CDATA is left by it first. */
export const whole = (n) =>
  `Field ${n} <script>planted(${n})</script>"><img src=//planted.invalid/${n} onerror=planted(${n})>'-planted(${n})-'` +
  `\`;planted(${n});"-planted(${n})-"*/planted(${n});/*</script></style></title></textarea>--><svg onload=planted(${n})>` +
  `\${planted(${n})}{{planted(${n})}} javascript:planted(${n}) ]]>\u2028[x](javascript:planted(${n})) **bold**`;

/** The same where a text is one plain line. */
export const line = (n) => whole(n).replace("\u2028", " ");

/** And what a terminal obeys: red from here on, a bell, a new title, written from right to left. */
export const control = (n) => `${whole(n)}\u001b[31m\u0007\u001b]0;planted ${n}\u0007\u202e\u0085end`;

/** For fields of few letters. */
export const short = (n) => `<img src=x onerror=planted(${n})>`; // 33 letters at most
export const shortest = (n) => `"><b id=implant>${n}`; // 20: what AIS has room for

/** For words of 100 bytes without characters of control. */
export const brief = (n) => `F${n}<script>planted(${n})</script>"><img src=x onerror=planted(${n})>'-planted(${n})-'`;

/** The name of a file: no '/'. */
export const named = (n) => `"><img src=x onerror=planted(${n})>'\u001b[31m\u202e`;

/** A text as a reader of a page can tell it: no matter where its lines end. */
export const read = (text) => text.replace(/\s+/gu, " ").trim();

/** A YAML scalar in double quotes. */
export const yaml = (text) =>
  JSON.stringify(text).replace(/[\u007f-\uffff]/gu, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);

/** The same as a string of CDL, which ncgen reads. */
export const cdl = (text) =>
  `"${text.replace(/["'\\?]/gu, "\\$&").replace(/[\u0000-\u001f]/gu, (c) => `\\${c.charCodeAt(0).toString(8).padStart(3, "0")}`)}"`;
