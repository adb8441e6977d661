// What this browser keeps of a person's settings.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { default_settings, read_settings } from 'page/look/settings';

test('OfKeptSettingsOnlyWhatIsSoundIsTaken', () => {
  const otherwise = default_settings(false);
  assert.deepEqual(read_settings('{', otherwise), otherwise);
  assert.deepEqual(
    read_settings('{"palette":"pink","site_offset_hours":99,"token":"x"}', otherwise),
    otherwise,
  );
  assert.deepEqual(read_settings('{"palette":"night","speed_unit":"knots"}', otherwise), {
    ...otherwise,
    palette: 'night',
    speed_unit: 'knots',
  });
});

test('comfort is kept in the settings', () => {
  const otherwise = default_settings(false);
  const kept = { headset_narrows: false, headset_is_seated: true };
  const read = read_settings(JSON.stringify({ ...otherwise, ...kept }), otherwise);
  assert.deepEqual([read.headset_narrows, read.headset_is_seated], [false, true]);
  const bad = read_settings('{"headset_narrows": 1, "headset_is_seated": "yes"}', otherwise);
  assert.deepEqual([bad.headset_narrows, bad.headset_is_seated], [true, false]);
});
