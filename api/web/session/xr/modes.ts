// The two ways into the scene with a headset, and what each asks the browser for. Nothing is asked
// for that the page could not do without, but where the floor is.

export type Mode = 'vr' | 'ar';
export const MODES: readonly Mode[] = ['vr', 'ar'];

export const SESSION_OF: Readonly<Record<Mode, XRSessionMode>> = {
  vr: 'immersive-vr',
  ar: 'immersive-ar',
};

/** From where the headset counts: in VR the floor, in AR where the head was at the start. */
export const SPACE_OF: Readonly<Record<Mode, XRReferenceSpaceType>> = {
  vr: 'local-floor',
  ar: 'local',
};

export const FEATURES_OF: Readonly<Record<Mode, XRSessionInit>> = {
  vr: {
    requiredFeatures: ['local-floor'],
    optionalFeatures: ['hand-tracking'],
  },
  ar: {
    requiredFeatures: ['local'],
    optionalFeatures: ['hit-test', 'hand-tracking'],
  },
};

/** Those that this browser says it has now; none without a headset, or over plain HTTP. */
export async function modes_there(xr: XRSystem | undefined): Promise<Set<Mode>> {
  const there = new Set<Mode>();
  for (const mode of MODES) {
    const is_there = await xr?.isSessionSupported(SESSION_OF[mode]).catch(() => false);
    if (is_there === true) there.add(mode);
  }
  return there;
}
