// A plate of two patches, one of them covered, and what was found on it, as a session tells it.
export const SQUARE = {
  name: 'plate',
  kind: 'bed',
  corners: [0, 0, -30, 1, 0, -30, 0, 1, -30, 1, 1, -30],
  triangles: [0, 1, 2, 1, 3, 2, 0, 2, 1],
  patch_of: [1, 0, -1],
};
export const INSPECTED = {
  is: 'welcome',
  vehicles: [{ vehicle: 0, name: 'rov' }],
  surfaces: [
    { vehicle: 0, surface: 0, name: 'plate', kind: 'bed', patches: 2, seen: 0.5, asked: 0.9 },
  ],
  covered: [{ vehicle: 0, surface: 0, seen: 0.5, runs: [[1, 1]] }],
  findings: [
    {
      vehicle: 0,
      findings: [
        { kind: 'crack', at: [0.5, 0.5, -30], size_m: 0.12, by: 'rov_camera' },
        { kind: 'marine_growth', at: [99, 0, -30] },
      ],
    },
  ],
};
