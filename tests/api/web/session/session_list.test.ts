// Which sessions a page offers to join, and which to begin.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  is_passing,
  read_session_list,
  session_label,
  session_of_address,
  to_join,
} from 'page/session/session_list';

const answer = {
  sessions: [
    { id: 'a', name: 'Night', state: 'running', seats: 1 },
    { id: 'a-2', name: 'Night', state: 'starting', seats: 0 },
    { id: 'b', name: 'Dawn', state: 'over', seats: 3 },
    { id: 'c', name: 'Dusk', state: 'failed', seats: 0, why: 'no forecast' },
    { id: 'd', name: 'Noon', state: 'ending', seats: 0 },
    { name: 'no id' },
    7,
  ],
  may_begin: [{ id: 'a', name: 'Night' }, { id: 'e' }, { name: 'no id' }],
};

test('WhatIsOverEndingOrFailedIsNotOfferedToJoin', () => {
  const { sessions } = read_session_list(answer);
  assert.equal(sessions.length, 5);
  assert.deepEqual(
    to_join(sessions).map((it) => it.id),
    ['a', 'a-2'],
  );
  assert.deepEqual(
    sessions.filter(is_passing).map((it) => it.id),
    ['a-2', 'd'],
  );
  assert.equal(sessions[3]?.why, 'no forecast');
});

test('TwoRunsOfOneScenarioAreToldApartByTheirIds', () => {
  const { sessions } = read_session_list(answer);
  const labels = sessions.map((it) => session_label(it, sessions));
  assert.equal(labels[0], 'Night, a (running, 1 person)');
  assert.equal(labels[1], 'Night, a-2 (starting, 0 people)');
  assert.equal(labels[2], 'Dawn (over, 3 people)');
});

test('WhatMayBeBegunIsReadAndIsNothingWhereNothingIsSaid', () => {
  assert.deepEqual(read_session_list(answer).may_begin, [
    { id: 'a', name: 'Night' },
    { id: 'e', name: 'e' },
  ]);
  assert.deepEqual(read_session_list({ sessions: [] }).may_begin, []);
  assert.deepEqual(read_session_list('nonsense'), { sessions: [], may_begin: [] });
});

test('TheAddressMayNameASession', () => {
  assert.equal(session_of_address('?session=night-cp-2'), 'night-cp-2');
  assert.equal(session_of_address(''), '');
});
