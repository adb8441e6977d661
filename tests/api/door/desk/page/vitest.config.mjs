// The tests stand beside page/ and name it as `page`.
import { fileURLToPath } from 'node:url';

export default {
  root: fileURLToPath(new URL('..', import.meta.url)),
  resolve: { alias: { page: fileURLToPath(new URL('../page', import.meta.url)) } },
  test: { include: ['tests/*.test.ts'], watch: false },
};
