// What every part of the page is given, and nothing else: the view, the server, the looks.
import type { Server } from '../server/server';
import type { Changed, View } from '../view';
import type { Look } from './look';

export interface Desk {
  readonly view: View;
  readonly server: Server;
  readonly look: Look;
  /** Called after each change, with what changed; a part redraws only what that touches. */
  onChange(listener: (changed: Changed) => void): void;
}
