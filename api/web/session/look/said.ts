// Words that are said at more than one place: at the desk, and on the board in a headset.
export interface Said {
  text: string;
  is_alarm: boolean;
}
export const NOTHING_SAID: Readonly<Said> = { text: '', is_alarm: false };
