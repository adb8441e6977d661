// The session's clock, as this station reckons it.
//
// The station asks at t0 (its own clock), the server answers with its clock c, which comes in at
// t1. With equal ways there and back the session's clock at t1 is c + (t1 - t0) / 2; the error is
// half of the round trip at most, so of several rounds the one with the least round trip is
// believed. A round is forgotten after a while, since two clocks drift.

const ROUND_IS_GOOD_MS = 120_000;
const ROUNDS_KEPT = 12;

interface Round {
  round_trip_ms: number;
  ahead_ms: number; // session's clock less our own
  at_ms: number;
}

export class SessionClock {
  private rounds: Round[] = [];
  private best: Round | null = null;

  /** One round: asked at `asked_ms`, answered at `now_ms`, both of our own clock. */
  heard(asked_ms: number, clock_ms: number, now_ms: number): void {
    const round_trip_ms = now_ms - asked_ms;
    if (!(round_trip_ms >= 0) || !Number.isFinite(clock_ms)) return;
    this.rounds = this.rounds
      .filter((round) => now_ms - round.at_ms < ROUND_IS_GOOD_MS)
      .slice(1 - ROUNDS_KEPT);
    this.rounds.push({
      round_trip_ms,
      ahead_ms: clock_ms + round_trip_ms / 2 - now_ms,
      at_ms: now_ms,
    });
    this.best = this.rounds.reduce((a, b) => (b.round_trip_ms < a.round_trip_ms ? b : a));
  }

  /** Of a new link to a server that may have begun again. */
  forget(): void {
    this.rounds = [];
    this.best = null;
  }

  get is_known(): boolean {
    return this.best !== null;
  }

  get round_trip_ms(): number | null {
    return this.best?.round_trip_ms ?? null;
  }

  /** Not a number until the first round is home. */
  at(now_ms: number): number {
    return this.best === null ? Number.NaN : now_ms + this.best.ahead_ms;
  }
}
