// The tests stand beside page/ and look/ and name them so.
import { fileURLToPath } from 'node:url';

const beside = (name) => fileURLToPath(new URL(`../${name}`, import.meta.url));

export default {
  root: beside(''),
  resolve: { alias: { page: beside('page'), look: beside('look') } },
  test: { include: ['tests/*.test.ts'], watch: false },
};
